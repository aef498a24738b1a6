//! What the loop does, exactly.
