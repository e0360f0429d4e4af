/* Ends what target_begin.inl begins. */
#if defined(GN_LANES_TARGET)
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
