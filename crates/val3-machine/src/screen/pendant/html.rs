//! Pages made with HTML and questions, as CS9 controllers have them. They are not in the manual; what programs in
//! public use of them is there.

use super::{Pendant, ScreenEvent};
use crate::screen::ReadingId;
use crate::screen::reading::{KeyEffect, Reading};
use val3_lang::ports::InputKind;

/// A question above the page.
#[derive(Debug, Clone)]
pub(super) struct Question {
    id: ReadingId,
    text: String,
    reading: Reading,
}

impl Question {
    pub(super) fn id(&self) -> ReadingId {
        self.id
    }
}

/// Instructions of s8.
impl Pendant {
    /// The application has a page of this name in its `interface` folder.
    pub fn add_html_page(&mut self, name: &str) {
        self.html_pages.insert(name.to_owned());
    }

    /// `userPage(string)`: shows a page; 0, or -1 if the application has none of this name. The user page below it
    /// stays the one that gets keys.
    pub fn show_html(&mut self, name: &str) -> i8 {
        if !self.html_pages.contains(name) {
            return -1;
        }
        self.events.push(ScreenEvent::HtmlShown(name.to_owned()));
        0
    }

    /// `userPageSet`: an event for the view of the page.
    pub fn set_html(&mut self, page: &str, id: &str, attribute: &str, value: &str) {
        let [page, id, attribute, value] = [page, id, attribute, value].map(str::to_owned);
        self.events.push(ScreenEvent::HtmlSet { page, id, attribute, value });
    }

    /// `userPageConfirm` with [`InputKind::Confirmation`], `userPagePrompt` with [`InputKind::Text`]: asks a question.
    /// [`Pendant::take_answer`] gives the answer; the instruction gives whether it is accepted.
    pub fn ask(&mut self, text: &str, asked: InputKind) -> ReadingId {
        let id = self.new_reading();
        self.events.push(ScreenEvent::Question(text.to_owned()));
        self.questions.push_back(Question { id, text: text.to_owned(), reading: Reading::new(asked) });
        id
    }

    /// The question that is shown, and what is entered so far.
    #[must_use]
    pub fn question(&self) -> Option<(&str, Option<String>)> {
        self.questions.front().map(|question| (question.text.as_str(), question.reading.shown()))
    }

    /// Gives a key to the question that was asked first; `false` if there is none.
    pub(super) fn answer_question(&mut self, key: u16) -> bool {
        let Some(question) = self.questions.front_mut() else { return false };
        if let KeyEffect::Ended(answer) = question.reading.press(key) {
            self.answers.insert(question.id, answer);
            self.questions.pop_front();
        }
        true
    }
}
