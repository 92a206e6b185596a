//! Access of instructions to the pendant (4.3).

use val3_lang::fault::{Fault, Result};
use val3_lang::memory::Place;
use val3_lang::ports::{InputKind, InputResult, Screen};

use super::Devices;
use crate::controller_state::MessageSeverity;
use crate::event::EventKind;
use crate::screen::{PageId, TextMode, display_columns};

impl Screen for Devices {
    fn print(&mut self, text: &str) {
        self.record(EventKind::Print { text: text.to_owned() });
    }

    fn create_page(&mut self, variable: Place) -> u32 {
        // A local screen and a screen in a field have no name.
        let numbered = || format!("screen{}", self.state.pendant.pages().count());
        let name = self.state.loaded.screen(variable).unwrap_or_else(numbered);
        self.state.pendant.create(&name).number()
    }

    fn show_page(&mut self, page: u32) {
        self.on_pendant(|pendant| pendant.show(PageId::from_number(page)));
    }

    fn fix_page(&mut self, fixed: bool) {
        self.on_pendant(|pendant| pendant.fix(fixed));
    }

    fn go_to(&mut self, page: u32, x: f64, y: f64) {
        self.state.pendant.go_to(PageId::from_number(page), x, y);
    }

    fn clear(&mut self, page: u32) {
        self.on_pendant(|pendant| pendant.clear(PageId::from_number(page)));
    }

    fn set_text_mode(&mut self, page: u32, mode: f64) -> Result<()> {
        let mode = TextMode::from_number(mode).ok_or(Fault::INVALID_PARAMETER)?;
        self.state.pendant.set_text_mode(PageId::from_number(page), mode);
        Ok(())
    }

    fn put(&mut self, page: u32, text: &str, ends_line: bool) {
        self.on_pendant(|pendant| pendant.put(PageId::from_number(page), text, ends_line));
    }

    fn set_title(&mut self, page: u32, text: &str) {
        self.on_pendant(|pendant| pendant.set_title(PageId::from_number(page), text));
    }

    fn pop_up(&mut self, text: &str, level: f64) {
        self.on_pendant(|pendant| pendant.show_pop_up(text, MessageSeverity::from_number(level)));
    }

    fn begin_reading(&mut self, page: u32, asked: InputKind) {
        let task = self.state.record.origin().task;
        self.state.questions.cancel(task, &mut self.state.pendant);
        let reading = self.on_pendant(|pendant| pendant.begin_reading(PageId::from_number(page), asked));
        self.state.questions.begin(task, reading);
    }

    fn begin_question(&mut self, text: &str, asked: InputKind) {
        let task = self.state.record.origin().task;
        self.state.questions.cancel(task, &mut self.state.pendant);
        let reading = self.on_pendant(|pendant| pendant.ask(text, asked));
        self.state.questions.begin(task, reading);
    }

    fn take_answer(&mut self) -> Option<InputResult> {
        self.state.questions.take_answer(self.state.record.origin().task, &mut self.state.pendant)
    }

    fn take_key(&mut self, page: u32) -> Option<u16> {
        self.state.pendant.take_key(PageId::from_number(page))
    }

    fn is_key_pressed(&mut self, page: u32, code: f64) -> bool {
        let code = code.round();
        (0.0..=f64::from(u16::MAX)).contains(&code) && {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the range")]
            let code = code as u16;
            self.state.pendant.is_key_pressed(PageId::from_number(page), code)
        }
    }

    fn display_columns(&mut self, text: &str) -> usize {
        display_columns(text)
    }

    fn show_html(&mut self, page: &str) -> i8 {
        self.on_pendant(|pendant| pendant.show_html(page))
    }

    fn set_html(&mut self, page: &str, id: &str, attribute: &str, value: &str) {
        self.on_pendant(|pendant| pendant.set_html(page, id, attribute, value));
    }
}
