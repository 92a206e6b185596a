//! Layout of the terminal: the pendant, the journal, and the state of the controller.

use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Modifier, Style, Stylize as _};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Clear, Paragraph, Wrap};
use val3_lang::ports::{SECOND, Time};
use val3_machine::controller_state::Robot;
use val3_machine::event::seconds;
use val3_machine::screen::{COLUMNS, Pendant, ROWS, ScreenCell};

use super::journal::Journal;

/// Duration of the visible and of the hidden phase of flashing text.
const FLASH: Time = SECOND / 2;

/// Size of the page with its border.
#[allow(clippy::cast_possible_truncation, reason = "42 and 16")]
const SIZE: (u16, u16) = (COLUMNS as u16 + 2, ROWS as u16 + 2);

/// Displayed objects.
pub(super) struct View<'a> {
    pub(super) pendant: &'a Pendant,
    pub(super) robot: &'a Robot,
    pub(super) journal: &'a Journal,
    /// Controller's clock.
    pub(super) now: Time,
    /// Whether the application was requested to stop.
    pub(super) stopping: bool,
}

impl View<'_> {
    /// Draws the terminal. If it is too small, the right and the lower part are cut off.
    pub(super) fn draw(&self, frame: &mut Frame<'_>) {
        let (width, height) = SIZE;
        let parts = [Constraint::Length(height), Constraint::Min(0), Constraint::Length(1)];
        let [page, journal, status] = Layout::vertical(parts).areas(frame.area());
        let page = Rect { width: page.width.min(width), ..page };
        self.draw_page(frame, page);
        self.draw_pop_up(frame, page);
        let lines = self.journal.last(journal.height.into()).map(Line::from);
        frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()), journal);
        frame.render_widget(Paragraph::new(self.status()).reversed(), status);
    }

    fn draw_page(&self, frame: &mut Frame<'_>, area: Rect) {
        let Some(page) = self.pendant.page(self.pendant.shown()) else { return };
        let rows = page.cells().map(|row| row.iter().map(|cell| self.span(cell)).collect::<Line<'_>>());
        let block = Block::bordered().title(page.title());
        frame.render_widget(Paragraph::new(rows.collect::<Vec<_>>()).block(block), area);
    }

    /// A column of the page. Flashing text keeps its background while it is hidden.
    fn span<'a>(&self, cell: &'a ScreenCell) -> Span<'a> {
        let seen = !cell.mode.is_flashing() || (self.now / FLASH).is_multiple_of(2);
        let gone = if cell.text.is_empty() { "" } else { " " };
        let style = if cell.mode.is_inverse() { Modifier::REVERSED.into() } else { Style::new() };
        Span::styled(if seen { cell.text.as_str() } else { gone }, style)
    }

    /// Draws the message or the question on top of the page.
    fn draw_pop_up(&self, frame: &mut Frame<'_>, page: Rect) {
        let question = self.pendant.question().map(|(text, entry)| {
            let entry = entry.map(|entry| format!("\n> {entry}")).unwrap_or_default();
            ("Return: accept, Esc: refuse", format!("{text}{entry}"))
        });
        let pop_up = self.pendant.pop_up().map(|pop_up| ("Esc: close", pop_up.text.clone()));
        let Some((keys, text)) = pop_up.or(question) else { return };
        let area = Rect { x: page.x + 3, y: page.y + 4, width: 36, height: 8 }.intersection(page);
        let block = Block::bordered().title_bottom(keys);
        frame.render_widget(Clear, area);
        frame.render_widget(Paragraph::new(text).wrap(Wrap { trim: false }).block(block), area);
    }

    fn status(&self) -> String {
        let power = if self.robot.is_powered() { "on" } else { "off" };
        let (mode, speed) = (self.robot.working_mode().name(), self.robot.monitor_speed());
        let keys =
            if self.stopping { "stopping; press Ctrl-C to end immediately" } else { "Ctrl-C stops, F9/F10 turn pages" };
        format!("power {power} | {mode} | speed {speed} % | {:.1} s | {keys}", seconds(self.now))
    }
}

#[cfg(test)]
mod tests;
