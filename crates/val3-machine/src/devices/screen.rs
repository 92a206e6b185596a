//! The pendant as instructions reach it.

use val3_lang::ports::Screen;

use super::Devices;
use crate::event::What;

impl Screen for Devices {
    fn print(&mut self, text: &str) {
        self.record(What::Print { text: text.to_owned() });
    }
}
