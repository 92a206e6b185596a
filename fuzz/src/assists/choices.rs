//! Bytes as a list of choices.

/// Choices that bytes make. After the last byte, each choice is the first possibility, which ends what it is part of.
pub(super) struct Choices<'b>(std::slice::Iter<'b, u8>);

impl<'b> Choices<'b> {
    pub(super) fn new(bytes: &'b [u8]) -> Self {
        Self(bytes.iter())
    }

    /// A number below `limit`; zero if `limit` is zero. Two bytes are used for more than 256 possibilities.
    pub(super) fn below(&mut self, limit: usize) -> usize {
        let mut next = || usize::from(self.0.next().copied().unwrap_or(0));
        let number = if limit > 256 { next() << 8 | next() } else { next() };
        number % limit.max(1)
    }

    /// One of several possibilities.
    pub(super) fn one_of<'t>(&mut self, texts: &[&'t str]) -> &'t str {
        texts.get(self.below(texts.len())).copied().unwrap_or("")
    }

    /// Whether something happens that happens once in `times`.
    pub(super) fn once_in(&mut self, times: usize) -> bool {
        self.below(times) == times.saturating_sub(1)
    }
}
