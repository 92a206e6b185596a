//! The pendant: user pages, displayed page, and the instructions for them (4.2, 4.3).

mod event;
mod html;
mod operator;

pub use event::{PopUp, ScreenEvent};
pub use html::{HtmlCallback, HtmlPage, HtmlValue};

use std::collections::{BTreeMap, VecDeque};

use val3_lang::keys;
use val3_lang::ports::{InputKind, InputResult};

use super::ids::{PageId, ReadingId};
use super::keyboard::Keyboard;
use super::page::PageContent;
use super::text_mode::TextMode;
use super::user_page::{Echo, UserScreen};
use crate::controller_state::MessageSeverity;

/// Pendant: pages, keys, pop-up.
///
/// It always shows a user page, initially the default page: the other pages of a real pendant do not exist here.
#[derive(Debug, Clone)]
pub struct Pendant {
    pages: BTreeMap<PageId, UserScreen>,
    next_page: u32,
    next_reading: u64,
    shown: PageId,
    fixed: bool,
    keyboard: Keyboard,
    typed: VecDeque<u16>,
    polled: bool,
    pop_up: Option<PopUp>,
    questions: VecDeque<html::Question>,
    html_pages: Vec<HtmlPage>,
    /// Index of the displayed HTML page.
    shown_html: Option<usize>,
    answers: BTreeMap<ReadingId, InputResult>,
    events: Vec<ScreenEvent>,
}

impl Default for Pendant {
    fn default() -> Self {
        Self {
            pages: BTreeMap::from([(PageId::DEFAULT, UserScreen::default())]),
            next_page: 1,
            next_reading: 0,
            shown: PageId::DEFAULT,
            fixed: false,
            keyboard: Keyboard::default(),
            typed: VecDeque::new(),
            polled: false,
            pop_up: None,
            questions: VecDeque::new(),
            html_pages: Vec::new(),
            shown_html: None,
            answers: BTreeMap::new(),
            events: Vec::new(),
        }
    }
}

/// Pages.
impl Pendant {
    /// Creates a page for a `screen` variable of this name.
    pub fn create(&mut self, name: &str) -> PageId {
        let id = PageId::from_number(self.next_page);
        self.next_page += 1;
        self.pages.insert(id, UserScreen::new(name));
        id
    }

    /// Removes the page of a variable that no longer exists. If it is displayed, the default page replaces it; the
    /// default page itself is never removed.
    pub fn remove(&mut self, page: PageId) {
        if page == PageId::DEFAULT {
            return;
        }
        self.pages.remove(&page);
        if self.shown == page {
            self.show(PageId::DEFAULT);
        }
    }

    /// Text, cursor and title of a page.
    #[must_use]
    pub fn page(&self, page: PageId) -> Option<&PageContent> {
        self.pages.get(&page).map(|user| &user.page)
    }

    /// Pages in the order of creation.
    pub fn pages(&self) -> impl Iterator<Item = PageId> {
        self.pages.keys().copied()
    }

    /// The name of a page's variable, empty for the default page.
    #[must_use]
    pub fn name(&self, page: PageId) -> &str {
        self.pages.get(&page).map_or("", |user| user.name.as_str())
    }

    /// The page that the pendant shows.
    #[must_use]
    pub fn shown(&self) -> PageId {
        self.shown
    }

    /// Whether a program keeps the operator on the user pages.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        self.fixed
    }

    /// The message above the page.
    #[must_use]
    pub fn pop_up(&self) -> Option<&PopUp> {
        self.pop_up.as_ref()
    }

    /// The events since the last call.
    pub fn take_events(&mut self) -> Vec<ScreenEvent> {
        std::mem::take(&mut self.events)
    }
}

/// Instructions that write.
impl Pendant {
    /// `userPage()`, `userPage(screen)`: shows a page.
    pub fn show(&mut self, page: PageId) {
        if self.pages.contains_key(&page) {
            let hides_html = self.shown_html.take().is_some();
            if self.shown != page || hides_html {
                self.shown = page;
                self.events.push(ScreenEvent::Shown(page));
            }
        }
    }

    /// `userPage(bool)`: keeps the operator on the user pages, or ends this. It names no page, so the default page is
    /// shown in both cases.
    pub fn fix(&mut self, fixed: bool) {
        self.fixed = fixed;
        self.show(PageId::DEFAULT);
    }

    /// `gotoxy`: column modulo 40, line modulo 14.
    pub fn go_to(&mut self, page: PageId, x: f64, y: f64) {
        if let Some(user) = self.pages.get_mut(&page) {
            user.page.go_to(x, y);
        }
    }

    /// `cls`.
    pub fn clear(&mut self, page: PageId) {
        if let Some(user) = self.pages.get_mut(&page) {
            user.page.clear();
            self.events.push(ScreenEvent::Cleared(page));
        }
    }

    /// `setTextMode`; a number that is no mode has no [`TextMode`] and is run-time error 70.
    pub fn set_text_mode(&mut self, page: PageId, mode: TextMode) {
        if let Some(user) = self.pages.get_mut(&page) {
            user.page.set_mode(mode);
        }
    }

    /// `put`, and `putln` if `ends_line`. A number is passed as its displayed text.
    pub fn put(&mut self, page: PageId, text: &str, ends_line: bool) {
        let Some(user) = self.pages.get_mut(&page) else { return };
        let at = user.page.put(text);
        if ends_line {
            user.page.end_line();
        }
        self.events.push(ScreenEvent::Put { page, at, text: text.to_owned(), ends_line });
    }

    /// `title`.
    pub fn set_title(&mut self, page: PageId, text: &str) {
        if let Some(user) = self.pages.get_mut(&page) {
            user.page.set_title(text);
            self.events.push(ScreenEvent::Title(page, text.to_owned()));
        }
    }

    /// `popUpMsg`: shows a message until the operator confirms it. A newer message replaces an unconfirmed one.
    pub fn show_pop_up(&mut self, text: &str, severity: MessageSeverity) {
        let pop_up = PopUp { text: text.to_owned(), severity };
        self.events.push(ScreenEvent::PopUp(pop_up.clone()));
        self.pop_up = Some(pop_up);
    }
}

/// Instructions that read.
impl Pendant {
    /// Begins a `get`, which ends when [`Self::take_answer`] returns an answer.
    pub fn begin_reading(&mut self, page: PageId, asked: InputKind) -> ReadingId {
        let id = self.new_reading();
        let echo = self.pages.get_mut(&page).and_then(|user| user.begin(id, asked));
        self.echo(page, echo);
        id
    }

    /// Removes and returns the result of a `get`; `None` while it waits.
    pub fn take_answer(&mut self, reading: ReadingId) -> Option<InputResult> {
        self.answers.remove(&reading)
    }

    /// Cancels a `get` whose task was killed.
    pub fn cancel_reading(&mut self, reading: ReadingId) {
        self.answers.remove(&reading);
        self.questions.retain(|question| question.id() != reading);
        for user in self.pages.values_mut() {
            user.cancel(reading);
        }
    }

    /// `getKey`: returns the last key pressed while the page was shown, since the last call; `None` for -1. A key that
    /// has ended a `get` counts as well.
    pub fn take_key(&mut self, page: PageId) -> Option<u16> {
        let key = self.pages.get_mut(&page).and_then(|user| user.last_key.take());
        self.polled |= key.is_none() && page == self.shown;
        key
    }

    /// Whether the key is held down and the page is shown (`isKeyPressed`); the keys 1, 2 and 3 count on any page.
    pub fn is_key_pressed(&mut self, page: PageId, code: u16) -> bool {
        let seen = page == self.shown || keys::is_always_seen(code);
        let pressed = seen && self.keyboard.is_down(code);
        self.polled |= seen && !pressed && self.typed.front() == Some(&code);
        pressed
    }

    fn new_reading(&mut self) -> ReadingId {
        let id = ReadingId::from_number(self.next_reading);
        self.next_reading += 1;
        id
    }

    fn echo(&mut self, page: PageId, echo: Option<Echo>) {
        let event = |(at, text)| ScreenEvent::Put { page, at, text, ends_line: false };
        self.events.extend(echo.map(event));
    }
}

#[cfg(test)]
mod tests;
