#pragma once
/**
 * @file xml.h
 * Texts in XML, SVG and HTML.
 */

#include <stdio.h>

/** Write a text so that it stands in an element or an attribute as it is; control characters, which XML
 *  has in no form, are left out.   Test  tests/base/test_xml.c */
void clod_xml_text(FILE *out, const char *text);
