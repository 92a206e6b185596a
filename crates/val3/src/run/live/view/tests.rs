use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::Buffer;
use val3_lang::ports::InputKind;
use val3_machine::controller_state::MessageSeverity;
use val3_machine::event::{Event, EventKind};
use val3_machine::screen::{PageId, TextMode};

use super::*;

const PAGE: PageId = PageId::DEFAULT;

/// Screen of a pendant at a time, in a terminal with 64 columns and 20 lines.
fn picture(pendant: &Pendant, now: Time) -> Buffer {
    let mut journal = Journal::default();
    for number in 1..=5 {
        journal.record_event(&Event {
            t: 0.0,
            task: None,
            at: None,
            kind: EventKind::Print { text: format!("line {number}") },
        });
    }
    let view = View { pendant, robot: &Robot::default(), journal: &journal, now, stopping: false };
    let mut terminal = Terminal::new(TestBackend::new(64, 20)).unwrap();
    terminal.draw(|frame| view.draw(frame)).unwrap();
    terminal.backend().buffer().clone()
}

fn shown(pendant: &Pendant) -> String {
    let buffer = picture(pendant, 1_500_000_000 - FLASH);
    let rows = buffer.content.chunks(64).map(|row| row.iter().map(|cell| cell.symbol()).collect::<String>());
    rows.map(|row| row.trim_end().to_owned() + "\n").collect()
}

fn menu() -> Pendant {
    let mut pendant = Pendant::default();
    pendant.set_title(PAGE, "Palletiser");
    pendant.put(PAGE, "Boxes:", true);
    pendant.put(PAGE, "中文", false);
    pendant.go_to(PAGE, 0.0, 13.0);
    pendant.put(PAGE, "Start Stop                          Exit", false);
    pendant
}

#[test]
fn the_page_is_drawn_above_the_lines_and_the_state() {
    let mut pendant = menu();
    pendant.go_to(PAGE, 7.0, 0.0);
    pendant.begin_reading(PAGE, InputKind::Number { value: 12.0, shown: "12".to_owned() });
    pendant.press(53);
    insta::assert_snapshot!(shown(&pendant));
}

#[test]
fn a_pop_up_covers_the_page() {
    let mut pendant = menu();
    pendant.show_pop_up("The gripper is empty; put a box into it", MessageSeverity::Warning);
    insta::assert_snapshot!(shown(&pendant));
}

#[test]
fn a_question_shows_its_entry() {
    let mut pendant = Pendant::default();
    pendant.ask("Name?", InputKind::Text("box".to_owned()));
    let shown = shown(&pendant);
    assert!(shown.contains("Name?") && shown.contains("> box"), "{shown}");
}

#[test]
fn working_modes_are_shown() {
    for (mode, reversed, flashes) in [
        (TextMode::Standard, false, false),
        (TextMode::Inverse, true, false),
        (TextMode::Flashing, false, true),
        (TextMode::InverseFlashing, true, true),
    ] {
        let mut pendant = Pendant::default();
        pendant.set_text_mode(PAGE, mode);
        pendant.put(PAGE, "x", false);
        for (now, seen) in [(0, true), (FLASH, !flashes), (2 * FLASH, true)] {
            let cell = picture(&pendant, now)[(1, 1)].clone();
            assert_eq!(cell.modifier.contains(Modifier::REVERSED), reversed, "{mode:?} at {now}");
            assert_eq!(cell.symbol(), if seen { "x" } else { " " }, "{mode:?} at {now}");
        }
    }
}

#[test]
fn a_small_terminal_cuts_the_picture() {
    let (pendant, journal) = (menu(), Journal::default());
    let view = View { pendant: &pendant, robot: &Robot::default(), journal: &journal, now: 0, stopping: true };
    for (width, height) in [(1, 1), (20, 5), (42, 16)] {
        let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        terminal.draw(|frame| view.draw(frame)).unwrap();
    }
}
