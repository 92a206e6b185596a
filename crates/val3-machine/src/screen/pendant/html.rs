//! HTML pages and questions of CS9 controllers. They are not in the manual; this module supports the features that
//! public programs use.

use super::{Pendant, ScreenEvent};
use crate::screen::ReadingId;
use crate::screen::reading::{KeyEffect, ScreenReading};
use val3_lang::ports::InputKind;

/// HTML page: `interface/<name>.html` and its bindings.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct HtmlPage {
    /// Name of the page.
    pub name: String,
    /// Data that elements display.
    pub values: Vec<HtmlValue>,
    /// Programs that events of elements execute.
    pub callbacks: Vec<HtmlCallback>,
}

/// Data that an element's attribute displays.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HtmlValue {
    /// Id of the element.
    pub element: String,
    /// Attribute: `innerHTML`.
    pub attribute: String,
    /// Path of the data: `nSpeed[0]`.
    pub path: String,
}

/// Program that an element's event executes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HtmlCallback {
    /// Id of the element.
    pub element: String,
    /// Event: `click`.
    pub event: String,
    /// Program of the application, without parameters.
    pub program: String,
    /// Priority of the program's task, 1 to 100.
    pub priority: u32,
}

impl HtmlPage {
    /// The programs that a click on an element executes.
    pub fn clicked(&self, element: &str) -> impl Iterator<Item = &HtmlCallback> {
        self.callbacks.iter().filter(move |callback| callback.element == element && callback.event == "click")
    }
}

/// A question above the page.
#[derive(Debug, Clone)]
pub(super) struct Question {
    id: ReadingId,
    text: String,
    reading: ScreenReading,
}

impl Question {
    pub(super) fn id(&self) -> ReadingId {
        self.id
    }
}

/// Instructions of s8.
impl Pendant {
    /// Sets the pages of the application's folder `interface`. No page is displayed.
    pub fn set_html_pages(&mut self, pages: Vec<HtmlPage>) {
        (self.html_pages, self.shown_html) = (pages, None);
    }

    /// HTML pages.
    #[must_use]
    pub fn html_pages(&self) -> &[HtmlPage] {
        &self.html_pages
    }

    /// Displayed HTML page.
    #[must_use]
    pub fn shown_html(&self) -> Option<&HtmlPage> {
        self.html_pages.get(self.shown_html?)
    }

    /// `userPage(string)`: shows a page. Returns 0, or -1 if the application has no page with this name, in any letter
    /// case. The user page below the HTML page still receives the keys.
    pub fn show_html(&mut self, name: &str) -> i8 {
        let page = self.html_pages.iter().position(|page| page.name.eq_ignore_ascii_case(name));
        if page.is_none() {
            return -1;
        }
        self.shown_html = page;
        self.events.push(ScreenEvent::HtmlShown(name.to_owned()));
        0
    }

    /// `userPageSet`: an event for the view of the page.
    pub fn set_html(&mut self, page: &str, id: &str, attribute: &str, value: &str) {
        let [page, id, attribute, value] = [page, id, attribute, value].map(str::to_owned);
        self.events.push(ScreenEvent::HtmlSet { page, id, attribute, value });
    }

    /// `userPageConfirm` with [`InputKind::Confirmation`], `userPagePrompt` with [`InputKind::Text`]: displays a
    /// question. [`Pendant::take_answer`] returns the answer; the instruction returns whether it is accepted.
    pub fn ask(&mut self, text: &str, asked: InputKind) -> ReadingId {
        let id = self.new_reading();
        self.events.push(ScreenEvent::Question(text.to_owned()));
        self.questions.push_back(Question { id, text: text.to_owned(), reading: ScreenReading::new(asked) });
        id
    }

    /// Displayed question and the text entered so far.
    #[must_use]
    pub fn question(&self) -> Option<(&str, Option<String>)> {
        self.questions.front().map(|question| (question.text.as_str(), question.reading.shown()))
    }

    /// Passes a key to the oldest question. Returns `false` if no question is open.
    pub(super) fn answer_question(&mut self, key: u16) -> bool {
        let Some(question) = self.questions.front_mut() else { return false };
        if let KeyEffect::Ended(answer) = question.reading.press(key) {
            self.answers.insert(question.id, answer);
            self.questions.pop_front();
        }
        true
    }
}
