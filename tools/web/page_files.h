/* The files that were dropped on the page together with a model. */
#ifndef PAGE_FILES_H
#define PAGE_FILES_H

#include <stdint.h>

#define PAGE_NO_FILE UINT32_MAX

typedef struct page_file {
    char *name;
    uint8_t *bytes; /* null after page_files_forget_bytes */
    uint32_t size;
} page_file;

/* Adds a file. Returns memory for its bytes, which are not set; null if there is not enough. */
uint8_t *page_files_add(const char *name, uint32_t size);

uint32_t page_files_count(void);
const page_file *page_files_at(uint32_t number);

/* The number of the first file with this name; PAGE_NO_FILE if there is none. Folders do not count,
 * and neither does the case of the letters a to z, which differs between systems. */
uint32_t page_files_find(const char *name);

/* Frees the bytes of all files, or forgets the files. */
void page_files_forget_bytes(void);
void page_files_forget(void);

#endif
