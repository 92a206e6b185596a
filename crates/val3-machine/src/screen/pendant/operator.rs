//! Actions of the operator: keys, pages, pop-ups.

use std::ops::Bound;

use val3_lang::keys;

use super::{PageId, Pendant, ScreenEvent};
use crate::screen::keyboard::TAP;

/// The operator's side of the pendant.
impl Pendant {
    /// Presses a key, which stays down until [`Self::release`].
    pub fn press(&mut self, code: u16) {
        self.keyboard.press(code, None);
        self.press_key(code);
    }

    /// Releases a key.
    pub fn release(&mut self, code: u16) {
        self.keyboard.release(code);
    }

    /// Presses a key and releases it after [`TAP`]. `now` is in nanoseconds, like all times here.
    pub fn tap(&mut self, code: u16, now: u64) {
        self.keyboard.press(code, Some(now.saturating_add(TAP)));
        self.press_key(code);
    }

    /// Taps keys one after the other, each as soon as the program requests a key: a `get` waits on the displayed page,
    /// `getKey` has returned -1 there, `isKeyPressed` tests this key and it is up, a question is open, or a pop-up
    /// waits for confirmation and the key is Esc.
    pub fn type_on_request(&mut self, codes: impl IntoIterator<Item = u16>) {
        self.typed.extend(codes);
    }

    /// Releases tapped keys, and taps the next key to type if the program requests it. Called once in each cycle.
    pub fn advance(&mut self, now: u64) {
        self.keyboard.advance(now);
        if self.is_asked()
            && let Some(code) = self.typed.pop_front()
        {
            self.polled = false;
            self.tap(code, now);
        }
    }

    /// Time of the next effect of [`Self::advance`]; `None` if it waits for the program or the operator.
    #[must_use]
    pub fn next_due(&self, now: u64) -> Option<u64> {
        let types = self.is_asked() && !self.typed.is_empty();
        if types { Some(now) } else { self.keyboard.next_release() }
    }

    /// Confirms the pop-up (Ok key or Esc).
    pub fn confirm_pop_up(&mut self) {
        if self.pop_up.take().is_some() {
            self.events.push(ScreenEvent::PopUpConfirmed);
        }
    }

    /// User-Down: shows the page created after the displayed page; after the last page, the first page.
    pub fn show_next(&mut self) {
        let behind = (Bound::Excluded(self.shown), Bound::Unbounded);
        let next = self.pages.range(behind).next().or_else(|| self.pages.first_key_value());
        self.show(next.map_or(PageId::DEFAULT, |(id, _)| *id));
    }

    /// User-Up: shows the page created before the displayed page; before the first page, the last page.
    pub fn show_previous(&mut self) {
        let before = self.pages.range(..self.shown).next_back().or_else(|| self.pages.last_key_value());
        self.show(before.map_or(PageId::DEFAULT, |(id, _)| *id));
    }

    /// User-Shift-Down: shows the first page, which is the default page.
    pub fn show_first(&mut self) {
        self.show(PageId::DEFAULT);
    }

    /// User-Shift-Up: shows the page created last.
    pub fn show_last(&mut self) {
        let last = self.pages.last_key_value();
        self.show(last.map_or(PageId::DEFAULT, |(id, _)| *id));
    }

    fn is_asked(&self) -> bool {
        let reads = self.pages.get(&self.shown).is_some_and(super::UserScreen::is_read);
        let confirms = self.pop_up.is_some() && self.typed.front() == Some(&keys::ESC);
        reads || confirms || self.polled || self.question().is_some()
    }

    /// Processes a key: Esc confirms a pop-up, an open question receives all other keys, and otherwise the displayed
    /// page receives them.
    fn press_key(&mut self, code: u16) {
        if code == keys::ESC && self.pop_up.is_some() {
            return self.confirm_pop_up();
        }
        if self.answer_question(code) {
            return;
        }
        let page = self.shown;
        let Some(user) = self.pages.get_mut(&page) else { return };
        let (echo, ended) = user.press(code);
        self.answers.extend(ended);
        self.echo(page, echo);
    }
}
