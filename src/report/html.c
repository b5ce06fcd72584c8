#include "report/html.h"

void clod_html_text(FILE *out, const char *text)
{
    for (const char *at = text != NULL ? text : "-"; *at != '\0'; at++) {
        switch (*at) {
        case '&':
            fputs("&amp;", out);
            break;
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '"':
            fputs("&quot;", out);
            break;
        default:
            if ((unsigned char)*at >= ' ' || *at == '\t' || *at == '\n') {
                fputc(*at, out); // XML has no other control characters, not even escaped
            }
        }
    }
}

void clod_html_cell(FILE *out, const char *tag, const char *text)
{
    fprintf(out, "<%s>", tag);
    clod_html_text(out, text);
    fprintf(out, "</%s>", tag);
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
