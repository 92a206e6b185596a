use expect_test::{Expect, expect};
use val3_lang::keys::{ESC, RETURN};

use val3_lang::ports::OperatorInput;

use super::*;
use crate::screen::TAP;

const F1: u16 = 271;

fn lines(pendant: &Pendant, page: PageId) -> Vec<String> {
    pendant.page(page).unwrap().lines().collect()
}

/// One line an event.
#[expect(clippy::needless_pass_by_value, reason = "expect![] is a value")]
fn check_events(pendant: &mut Pendant, expected: Expect) {
    let text: Vec<String> = pendant.take_events().into_iter().map(line).collect();
    expected.assert_eq(&text.concat());
}

fn line(event: ScreenEvent) -> String {
    let place = |page: PageId| if page == PageId::DEFAULT { "default".to_owned() } else { page.number().to_string() };
    match event {
        ScreenEvent::Shown(page) => format!("shown {}\n", place(page)),
        ScreenEvent::Put { page, at, text, ends_line } => {
            let end = if ends_line { " ends the line" } else { "" };
            format!("put {} ({},{}) {text:?}{end}\n", place(page), at.column, at.row)
        }
        ScreenEvent::Title(page, text) => format!("title {} {text:?}\n", place(page)),
        ScreenEvent::Cleared(page) => format!("cleared {}\n", place(page)),
        ScreenEvent::PopUp(pop_up) => format!("pop-up {:?} {}\n", pop_up.severity, pop_up.text),
        ScreenEvent::PopUpConfirmed => "pop-up confirmed\n".to_owned(),
        ScreenEvent::HtmlShown(page) => format!("html {page}\n"),
        ScreenEvent::HtmlSet { page, id, attribute, value } => format!("html {page} {id}.{attribute}={value}\n"),
        ScreenEvent::Question(text) => format!("question {text}\n"),
    }
}

#[test]
fn a_page_is_written_whether_it_is_shown_or_not() {
    let mut pendant = Pendant::default();
    let setup = pendant.create("scSetup");
    pendant.put(setup, "hidden", true);
    pendant.put(PageId::DEFAULT, "default", false);
    assert_eq!(pendant.shown(), PageId::DEFAULT);
    assert_eq!(
        (lines(&pendant, setup)[0].as_str(), lines(&pendant, PageId::DEFAULT)[0].as_str()),
        ("hidden", "default")
    );
    pendant.show(setup);
    assert_eq!((pendant.shown(), pendant.name(setup)), (setup, "scSetup"));
    pendant.show(PageId::DEFAULT);
    assert_eq!(lines(&pendant, setup)[0], "hidden");
}

#[test]
fn events_contain_the_written_text() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    pendant.set_title(page, "Palletiser");
    pendant.clear(page);
    pendant.go_to(page, 38.0, 2.0);
    pendant.put(page, "abc", false);
    pendant.put(page, "12", true);
    pendant.show(page);
    pendant.show(page);
    pendant.show_pop_up("Close the guard", MessageSeverity::Information);
    pendant.confirm_pop_up();
    check_events(
        &mut pendant,
        expect![[r#"
            title 1 "Palletiser"
            cleared 1
            put 1 (38,2) "abc"
            put 1 (1,3) "12" ends the line
            shown 1
            pop-up Information Close the guard
            pop-up confirmed
        "#]],
    );
}

#[test]
fn fixing_the_page_shows_the_default_one() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    pendant.show(page);
    pendant.fix(true);
    assert!(pendant.is_fixed());
    assert_eq!(pendant.shown(), PageId::DEFAULT);
    pendant.fix(false);
    assert!(!pendant.is_fixed());
}

#[test]
fn the_default_page_replaces_a_deleted_page() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    pendant.show(page);
    pendant.remove(page);
    pendant.remove(PageId::DEFAULT);
    assert_eq!(pendant.shown(), PageId::DEFAULT);
    assert!(pendant.page(page).is_none() && pendant.page(PageId::DEFAULT).is_some());
    pendant.show(page);
    pendant.put(page, "nowhere", false);
    assert_eq!(pendant.shown(), PageId::DEFAULT);
}

#[test]
fn the_operator_turns_pages() {
    let mut pendant = Pendant::default();
    let (first, last) = (pendant.create("scA"), pendant.create("scB"));
    let mut shown = Vec::new();
    for turn in [Pendant::show_next, Pendant::show_next, Pendant::show_next, Pendant::show_previous] {
        turn(&mut pendant);
        shown.push(pendant.shown());
    }
    assert_eq!(shown, [first, last, PageId::DEFAULT, last]);
    pendant.show_previous();
    assert_eq!(pendant.shown(), first);
    pendant.show_first();
    assert_eq!(pendant.shown(), PageId::DEFAULT);
    pendant.show_last();
    assert_eq!(pendant.shown(), last);
}

#[test]
fn get_key_gives_the_last_key_once() {
    let mut pendant = Pendant::default();
    pendant.tap(97, 0);
    pendant.tap(98, 0);
    assert_eq!(pendant.take_key(PageId::DEFAULT), Some(98));
    assert_eq!(pendant.take_key(PageId::DEFAULT), None);
}

#[test]
fn a_page_has_the_keys_pressed_while_it_is_shown() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    pendant.tap(97, 0);
    assert_eq!(pendant.take_key(page), None);
    pendant.show(page);
    pendant.tap(98, 0);
    assert_eq!((pendant.take_key(page), pendant.take_key(PageId::DEFAULT)), (Some(98), Some(97)));
}

#[test]
fn a_key_is_pressed_while_it_is_held_and_its_page_shown() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    for code in [97, 281] {
        pendant.press(code);
    }
    assert!(pendant.is_key_pressed(PageId::DEFAULT, 97));
    assert!(!pendant.is_key_pressed(page, 97));
    assert!(pendant.is_key_pressed(page, 281));
    pendant.release(97);
    pendant.release(281);
    assert!(!pendant.is_key_pressed(PageId::DEFAULT, 97) && !pendant.is_key_pressed(page, 281));
}

#[test]
fn a_tapped_key_is_down_for_a_while() {
    let mut pendant = Pendant::default();
    pendant.tap(F1, 0);
    assert!(pendant.is_key_pressed(PageId::DEFAULT, F1));
    assert_eq!(pendant.next_due(0), Some(TAP));
    pendant.advance(TAP);
    assert!(!pendant.is_key_pressed(PageId::DEFAULT, F1));
}

#[test]
fn a_get_waits_for_a_key_on_its_page() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    let (here, there) =
        (pendant.begin_reading(PageId::DEFAULT, InputKind::Key), pendant.begin_reading(page, InputKind::Key));
    assert_eq!(pendant.take_answer(here), None);
    pendant.tap(97, 0);
    assert_eq!(pendant.take_answer(here), Some(InputResult { key: 97, entry: OperatorInput::Unchanged }));
    assert_eq!(pendant.take_answer(there), None);
    pendant.show(page);
    pendant.tap(98, 0);
    assert_eq!(pendant.take_answer(there).unwrap().key, 98);
    assert_eq!(pendant.take_answer(there), None);
}

#[test]
fn a_key_from_before_does_not_end_a_get() {
    let mut pendant = Pendant::default();
    pendant.tap(97, 0);
    let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
    assert_eq!(pendant.take_answer(reading), None);
}

#[test]
fn the_first_of_two_gets_on_a_page_gets_the_key() {
    let mut pendant = Pendant::default();
    let first = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
    let second = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
    pendant.tap(97, 0);
    assert_eq!((pendant.take_answer(first).unwrap().key, pendant.take_answer(second)), (97, None));
    pendant.cancel_reading(second);
    pendant.tap(98, 0);
    assert_eq!(pendant.take_answer(second), None);
}

#[test]
fn an_entry_is_shown_at_the_cursor_which_stays() {
    let mut pendant = Pendant::default();
    pendant.put(PageId::DEFAULT, "speed: ", false);
    let cursor = pendant.page(PageId::DEFAULT).unwrap().cursor();
    pendant.take_events();
    let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Number { value: 50.0, shown: "50".to_owned() });
    for key in [263, 263, 55, RETURN] {
        pendant.tap(key, 0);
    }
    assert_eq!(pendant.take_answer(reading), Some(InputResult { key: RETURN, entry: OperatorInput::Number(7.0) }));
    assert_eq!(pendant.page(PageId::DEFAULT).unwrap().cursor(), cursor);
    assert_eq!(lines(&pendant, PageId::DEFAULT)[0], "speed: 7");
    check_events(
        &mut pendant,
        expect![[r#"
            put default (7,0) "50"
            put default (7,0) "5 "
            put default (7,0) "  "
            put default (7,0) "7 "
            put default (7,0) "7 "
        "#]],
    );
}

#[test]
fn esc_shows_the_former_value() {
    let mut pendant = Pendant::default();
    let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Text("ab".to_owned()));
    for key in [99, 100, ESC] {
        pendant.tap(key, 0);
    }
    assert_eq!(pendant.take_answer(reading), Some(InputResult { key: ESC, entry: OperatorInput::Unchanged }));
    assert_eq!(lines(&pendant, PageId::DEFAULT)[0], "ab");
}

#[test]
fn esc_only_confirms_a_pop_up() {
    let mut pendant = Pendant::default();
    let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
    pendant.show_pop_up("first", MessageSeverity::Information);
    pendant.show_pop_up("second", MessageSeverity::Error);
    assert_eq!(pendant.pop_up().unwrap().text, "second");
    pendant.tap(ESC, 0);
    assert_eq!(pendant.take_answer(reading), None);
    assert_eq!(pendant.pop_up(), None);
    pendant.tap(ESC, 0);
    assert_eq!(pendant.take_answer(reading).unwrap().key, ESC);
}

#[test]
fn keys_are_typed_when_a_get_asks() {
    let mut pendant = Pendant::default();
    pendant.type_on_request([97, 98]);
    pendant.advance(0);
    assert_eq!((pendant.next_due(0), pendant.take_key(PageId::DEFAULT)), (None, None));
    let mut typed = Vec::new();
    for _ in 0..2 {
        let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
        assert_eq!(pendant.next_due(7), Some(7));
        pendant.advance(7);
        typed.push(pendant.take_answer(reading).unwrap().key);
    }
    assert_eq!(typed, [97, 98]);
}

#[test]
fn keys_are_typed_between_two_calls_of_get_key() {
    let mut pendant = Pendant::default();
    pendant.type_on_request([97, 98]);
    let mut seen = Vec::new();
    for now in 0..5 {
        seen.push(pendant.take_key(PageId::DEFAULT));
        pendant.advance(now);
    }
    assert_eq!(seen, [None, Some(97), None, Some(98), None]);
}

#[test]
fn keys_are_typed_when_a_program_asks_for_them() {
    let mut pendant = Pendant::default();
    pendant.type_on_request([F1]);
    assert!(!pendant.is_key_pressed(PageId::DEFAULT, RETURN));
    assert_eq!(pendant.next_due(0), None);
    assert!(!pendant.is_key_pressed(PageId::DEFAULT, F1));
    pendant.advance(0);
    assert!(pendant.is_key_pressed(PageId::DEFAULT, F1));
}

#[test]
fn changes_of_html_pages_are_events() {
    let mut pendant = Pendant::default();
    pendant.set_html_pages(vec![HtmlPage { name: "Main".to_owned(), ..HtmlPage::default() }]);
    assert_eq!((pendant.show_html("main"), pendant.show_html("other")), (0, -1));
    assert_eq!(pendant.shown_html().map(|page| page.name.as_str()), Some("Main"));
    pendant.set_html("main", "lblDone", "innerHTML", "12");
    check_events(
        &mut pendant,
        expect![[r#"
            html main
            html main lblDone.innerHTML=12
        "#]],
    );
    pendant.show(PageId::DEFAULT);
    assert_eq!(pendant.shown_html(), None);
}

#[test]
fn a_question_takes_the_keys_before_the_page() {
    let mut pendant = Pendant::default();
    let reading = pendant.begin_reading(PageId::DEFAULT, InputKind::Key);
    let prompt = pendant.ask("Order number", InputKind::Text("A".to_owned()));
    let confirmation = pendant.ask("Empty the gripper?", InputKind::Confirmation);
    assert_eq!(pendant.question(), Some(("Order number", Some("A".to_owned()))));
    for key in [55, RETURN] {
        pendant.tap(key, 0);
    }
    assert_eq!(pendant.take_answer(prompt).unwrap().entry, OperatorInput::Text("A7".to_owned()));
    assert_eq!(pendant.question(), Some(("Empty the gripper?", None)));
    pendant.tap(ESC, 0);
    assert!(!pendant.take_answer(confirmation).unwrap().is_accepted());
    assert_eq!(pendant.take_key(PageId::DEFAULT), None);
    assert_eq!(pendant.question(), None);
    assert_eq!(pendant.take_answer(reading), None);
}

#[test]
fn the_question_of_a_killed_task_is_removed() {
    let mut pendant = Pendant::default();
    let question = pendant.ask("Empty the gripper?", InputKind::Confirmation);
    pendant.cancel_reading(question);
    assert_eq!(pendant.question(), None);
    pendant.type_on_request([RETURN]);
    assert_eq!(pendant.next_due(0), None);
    pendant.ask("Go on?", InputKind::Confirmation);
    assert_eq!(pendant.next_due(0), Some(0));
}

#[test]
fn nothing_is_typed_for_a_page_that_is_not_shown() {
    let mut pendant = Pendant::default();
    let page = pendant.create("scMain");
    pendant.type_on_request([97]);
    assert_eq!(pendant.take_key(page), None);
    pendant.begin_reading(page, InputKind::Key);
    assert_eq!(pendant.next_due(0), None);
    pendant.show(page);
    assert_eq!(pendant.next_due(0), Some(0));
}
