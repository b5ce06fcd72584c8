#include "report/scripts.h"

#include <stddef.h>

#include "report/html.h"

/** The bytes of a file as a text of this name. */
#define EMBED(name, path)                                                                      \
    __asm__(".pushsection .rodata\n" #name ":\n.incbin \"" path "\"\n.byte 0\n.popsection\n"); \
    extern const char name[] __attribute__((visibility("hidden")))

EMBED(clod_scripts_style_bytes, CLOD_REPORT_STYLE);

#ifdef CLOD_REPORT_BUNDLE
EMBED(clod_scripts_bundle_bytes, CLOD_REPORT_BUNDLE);
EMBED(clod_scripts_licence_bytes, CLOD_REPORT_LICENCES);
#endif

const char *clod_scripts_style(void)
{
    return clod_scripts_style_bytes;
}

const char *clod_scripts_bundle(void)
{
#ifdef CLOD_REPORT_BUNDLE
    return clod_scripts_bundle_bytes;
#else
    return NULL;
#endif
}

void clod_scripts_licences(FILE *out)
{
#ifdef CLOD_REPORT_BUNDLE
    clod_html_folded(out, "Licences of the scripts in this page", clod_scripts_licence_bytes);
#else
    (void)out;
#endif
}
