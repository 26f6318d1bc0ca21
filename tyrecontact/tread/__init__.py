"""The tread: viscoelastic layers, their surface compliance, and element kernels in time."""
