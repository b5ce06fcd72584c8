#include "base/xml.h"

void clod_xml_text(FILE *out, const char *text)
{
    for (const char *at = text; *at != '\0'; at++) {
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
