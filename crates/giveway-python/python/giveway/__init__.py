from giveway._native import VERSION as __version__
