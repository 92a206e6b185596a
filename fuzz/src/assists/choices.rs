//! Bytes as a sequence of choices.

/// Choices determined by bytes. After the last byte, each choice is the first possibility, which ends the present
/// construct.
pub(super) struct Choices<'b>(std::slice::Iter<'b, u8>);

impl<'b> Choices<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self(bytes.iter())
    }

    /// Returns a number below `limit`, or zero if `limit` is zero. More than 256 possibilities use two bytes.
    pub(super) fn below(&mut self, limit: usize) -> usize {
        let mut next = || usize::from(self.0.next().copied().unwrap_or(0));
        let number = if limit > 256 { next() << 8 | next() } else { next() };
        number % limit.max(1)
    }

    /// Returns one of several possibilities.
    pub(super) fn one_of<'t>(&mut self, texts: &[&'t str]) -> &'t str {
        texts.get(self.below(texts.len())).copied().unwrap_or("")
    }

    /// Whether an event with the probability 1 / `times` happens.
    pub(super) fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == times.saturating_sub(1)
    }
}
