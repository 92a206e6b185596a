//! The pendant: user pages, keys and messages (4).

/// The pendant.
pub trait Screen {
    /// Shows a line of text that `?` prints.
    fn print(&mut self, text: &str);
}
