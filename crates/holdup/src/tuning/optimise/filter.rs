//! The filter of the derivative action, as a part of the design.

/// How the derivative action is filtered.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Filter {
    /// Not at all.
    #[default]
    None,
    /// The filter time is a free setting.
    Free,
    /// The filter time is this part of the derivative time, Tf/Td \[–\].
    Held(f64),
}

impl Filter {
    /// The filter where nothing is said of it: free where a limit is infinite without one, else none.
    #[must_use]
    pub fn for_limits(limits: &super::Limits) -> Self {
        let needs = |limit: &super::Limit| limit.quantity.needs_filter();
        if limits.list().iter().any(needs) { Self::Free } else { Self::None }
    }
}
