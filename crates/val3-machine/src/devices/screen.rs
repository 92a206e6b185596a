//! The pendant as instructions reach it (4.3).

use val3_lang::fault::{Fault, Result};
use val3_lang::memory::Place;
use val3_lang::ports::{InputKind, InputResult, Screen, Time};

use super::Devices;
use crate::controller_state::Severity;
use crate::event::EventKind;
use crate::screen::{PageId, ReadingId, ScreenEvent, TextMode, display_columns};

impl Screen for Devices {
    fn print(&mut self, text: &str) {
        self.record(EventKind::Print { text: text.to_owned() });
    }

    fn create_page(&mut self, variable: Place) -> u32 {
        let name = self.name_of_screen(variable);
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
        self.on_pendant(|pendant| pendant.show_pop_up(text, Severity::from_number(level)));
    }

    fn begin_reading(&mut self, page: u32, asked: InputKind) {
        self.give_up_reading();
        let reading = self.on_pendant(|pendant| pendant.begin_reading(PageId::from_number(page), asked));
        self.state.readings.insert(self.state.record.origin().task, reading);
    }

    fn begin_question(&mut self, text: &str, asked: InputKind) {
        self.give_up_reading();
        let reading = self.on_pendant(|pendant| pendant.ask(text, asked));
        self.state.readings.insert(self.state.record.origin().task, reading);
    }

    fn take_answer(&mut self) -> Option<InputResult> {
        let reading = self.reading()?;
        let answer = self.state.pendant.take_answer(reading)?;
        self.state.readings.remove(&self.state.record.origin().task);
        Some(answer)
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

impl Devices {
    /// Does something on the pendant for the task that runs, and records what is seen of it.
    fn on_pendant<T>(&mut self, act: impl FnOnce(&mut crate::screen::Pendant) -> T) -> T {
        let result = act(&mut self.state.pendant);
        let seen = self.take_seen();
        seen.into_iter().for_each(|kind| self.record(kind));
        result
    }

    /// Records what the operator has done on the pendant.
    pub(super) fn record_pendant(&mut self, now: Time) {
        let seen = self.take_seen();
        seen.into_iter().for_each(|kind| self.record_outside(now, kind));
    }

    fn take_seen(&mut self) -> Vec<EventKind> {
        let events = self.state.pendant.take_events();
        events.into_iter().filter_map(|event| self.seen(event)).collect()
    }

    /// The form of an event in the record. A question has the form of a message.
    fn seen(&self, event: ScreenEvent) -> Option<EventKind> {
        let screen = |page| self.state.pendant.name(page).to_owned();
        let cell = |number| u8::try_from(number).unwrap_or(u8::MAX);
        Some(match event {
            ScreenEvent::Put { page, at, text, .. } => {
                EventKind::Put { screen: screen(page), x: cell(at.column), y: cell(at.row), text }
            }
            ScreenEvent::Title(page, text) => EventKind::Title { screen: screen(page), text },
            ScreenEvent::Cleared(page) => EventKind::Cls { screen: screen(page) },
            ScreenEvent::PopUp(pop_up) => EventKind::Popup { text: pop_up.text },
            ScreenEvent::Question(text) => EventKind::Popup { text },
            ScreenEvent::HtmlSet { page, id, attribute, value } => EventKind::Html { page, id, attribute, value },
            ScreenEvent::Shown(_) | ScreenEvent::PopUpConfirmed | ScreenEvent::HtmlShown(_) => return None,
        })
    }

    /// The question of the task that runs to the operator.
    fn reading(&self) -> Option<ReadingId> {
        self.state.readings.get(&self.state.record.origin().task).copied()
    }

    fn give_up_reading(&mut self) {
        self.cancel_reading(self.state.record.origin().task);
    }

    /// Cancels the question of a task.
    pub(super) fn cancel_reading(&mut self, task: val3_lang::ports::TaskNumber) {
        if let Some(reading) = self.state.readings.remove(&task) {
            self.state.pendant.cancel_reading(reading);
        }
    }

    /// The name of a screen in the record: that of the global variable, with its index or key if it has several
    /// values; `screen` and a number for a local one and for a field.
    fn name_of_screen(&self, variable: Place) -> String {
        self.state.loaded.screen(variable).unwrap_or_else(|| format!("screen{}", self.state.pendant.pages().count()))
    }
}
