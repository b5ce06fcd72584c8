#include "report/html.h"

#include "base/xml.h"

void clod_html_text(FILE *out, const char *text)
{
    clod_xml_text(out, text != NULL ? text : "-");
}

void clod_html_cell(FILE *out, const char *tag, const char *text)
{
    fprintf(out, "<%s>", tag);
    clod_html_text(out, text);
    fprintf(out, "</%s>", tag);
}

void clod_html_fact(FILE *out, const char *name, const char *text)
{
    fputs("<tr>", out);
    clod_html_cell(out, "th", name);
    clod_html_cell(out, "td", text);
    fputs("</tr>\n", out);
}

void clod_html_section(FILE *out, const char *id, const char *title)
{
    fprintf(out, "<h2 id=\"%s\">", id);
    clod_html_text(out, title);
    fputs("</h2>\n", out);
}

void clod_html_folded(FILE *out, const char *title, const char *text)
{
    fputs("<details><summary>", out);
    clod_html_text(out, title);
    fputs("</summary>\n<pre>", out);
    clod_html_text(out, text);
    fputs("</pre></details>\n", out);
}
