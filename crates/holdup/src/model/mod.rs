//! What is controlled, and by what.
