#include "report/sheet.h"

#include <string.h>

#include "base/memory.h"
#include "output/file.h"
#include "report/figure_json.h"
#include "report/figure_svg.h"
#include "report/html.h"
#include "report/scripts.h"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for the page of the report.");
}

bool clod_sheet_open(clod_sheet *self, clod_status *status)
{
    *self = (clod_sheet){0};
    self->body = clod_text_open(&self->body_text);
    self->figures = clod_text_open(&self->figures_text);
    self->views = clod_text_open(&self->views_text);
    return (self->body != NULL && self->figures != NULL && self->views != NULL) ||
           fail_memory(status);
}

static bool is_taken(const clod_sheet *self, const char *name)
{
    for (size_t k = 0; k < self->file_count; k++) {
        if (strcmp(self->files[k].name, name) == 0) {
            return true;
        }
    }
    return false;
}

/** Put -2, -3 and so on behind the name until no earlier figure has it. */
static void make_unique(const clod_sheet *self, clod_figure *figure)
{
    char name[sizeof figure->name];
    snprintf(name, sizeof name, "%.*s", (int)sizeof name - 16, figure->name);
    for (unsigned k = 2; is_taken(self, figure->name); k++) {
        snprintf(figure->name, sizeof figure->name, "%.*s-%u", (int)sizeof name - 16, name, k);
    }
}

/** Keep a figure's SVG as a file, and show it in the body. */
static void take_svg(clod_sheet *self, const clod_figure *figure)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    clod_figure_file *grown =
        clod_memory_grow(self->files, self->file_count, self->file_count + 1, sizeof *grown);
    self->files = grown != NULL ? grown : self->files;
    if (out != NULL) {
        clod_figure_svg(out, figure);
    }
    char *svg = out != NULL ? clod_text_close(&text) : NULL;
    if (svg == NULL || grown == NULL) {
        clod_memory_free(svg);
        self->lost = true;
        return;
    }
    fputs(svg, self->body);
    clod_figure_file *file = &self->files[self->file_count++];
    snprintf(file->name, sizeof file->name, "%s", figure->name);
    file->svg = svg;
}

void clod_sheet_figure(clod_sheet *self, clod_figure *figure)
{
    self->lost = self->lost || figure->lost;
    if (!self->lost && clod_figure_shows(figure)) {
        make_unique(self, figure);
        fprintf(self->body, "<figure class=\"figure%s\" id=\"figure-%s\"><h3>",
                figure->equal && figure->map.number == NULL ? " wide" : "", figure->name);
        clod_html_text(self->body, figure->title);
        fputs("</h3><div class=\"still\">", self->body);
        take_svg(self, figure);
        fputs("</div><div class=\"live\"></div>", self->body);
        if (figure->note[0] != '\0') {
            fputs("<figcaption>", self->body);
            clod_html_text(self->body, figure->note);
            fputs("</figcaption>", self->body);
        }
        char alike[256];
        if (clod_figure_alike(figure, alike)) {
            fputs("<figcaption>", self->body);
            clod_html_text(self->body, alike);
            fputs("</figcaption>", self->body);
        }
        fputs("</figure>\n", self->body);
        fputs(self->file_count > 1 ? ",\n" : "", self->figures);
        clod_figure_json(self->figures, figure);
    }
    clod_figure_fini(figure);
}

void clod_sheet_columns(clod_sheet *self, bool begin)
{
    fputs(begin ? "<div class=\"figures\">\n" : "</div>\n", self->body);
}

FILE *clod_sheet_view(clod_sheet *self)
{
    fprintf(self->body, "<div class=\"view\" id=\"view-%zu\"></div>\n", self->view_count);
    fputs(self->view_count++ > 0 ? ",\n" : "", self->views);
    return self->views;
}

/** The whole file. */
static char *make_file(clod_sheet *self, const char *title)
{
    clod_text text;
    char *parts[3] = {clod_text_close(&self->body_text), clod_text_close(&self->figures_text),
                      clod_text_close(&self->views_text)};
    self->body = self->figures = self->views = NULL;
    FILE *out = parts[0] != NULL && parts[1] != NULL && parts[2] != NULL && !self->lost
                    ? clod_text_open(&text)
                    : NULL;
    if (out != NULL) {
        fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
              "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
              "<meta name=\"generator\" content=\"clod report\">\n<title>",
              out);
        clod_html_text(out, title);
        fprintf(out, "</title>\n<style>\n%s</style></head>\n<body>\n<main>\n%s",
                clod_scripts_style(), parts[0]);
        clod_scripts_licences(out);
        fprintf(out,
                "</main>\n<script type=\"application/json\" id=\"clod-data\">{\"figures\":[%s],"
                "\n\"views\":[%s]}</script>\n",
                parts[1], parts[2]);
        if (clod_scripts_bundle() != NULL) {
            fprintf(out, "<script>%s</script>\n", clod_scripts_bundle());
        }
        fputs("</body></html>\n", out);
    }
    for (int k = 0; k < 3; k++) {
        clod_memory_free(parts[k]);
    }
    return out != NULL ? clod_text_close(&text) : NULL;
}

bool clod_sheet_write(clod_sheet *self, const char *title, const char *path,
                      clod_status *status)
{
    char *file = make_file(self, title);
    if (file == NULL) {
        return fail_memory(status);
    }
    const bool good = clod_figure_files_check(path, self->files, self->file_count, status) &&
                      clod_figure_files_write(path, self->files, self->file_count, status) &&
                      clod_file_replace(path, NULL, 0, file, strlen(file), status);
    clod_memory_free(file);
    return good;
}

/** End a text that may not be open. */
static void drop(FILE *out, clod_text *text)
{
    if (out != NULL) {
        clod_memory_free(clod_text_close(text));
    }
}

void clod_sheet_fini(clod_sheet *self)
{
    drop(self->body, &self->body_text);
    drop(self->figures, &self->figures_text);
    drop(self->views, &self->views_text);
    for (size_t k = 0; k < self->file_count; k++) {
        clod_memory_free(self->files[k].svg);
    }
    clod_memory_free(self->files);
    *self = (clod_sheet){0};
}
