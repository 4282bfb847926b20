__attribute__((visibility("default"))) int acme_helper() { return 1; }
