//! The pendant (4.3).

use expect_test::{Expect, expect};
use val3_machine::screen::HtmlPage;
use val3_tests::running::Running;

#[track_caller]
fn check_page(listing: &str, expected: Expect) {
    expected.assert_eq(&Running::start(listing).to_the_end().page());
}

#[track_caller]
fn check_record(listing: &str, expected: Expect) {
    expected.assert_eq(&Running::start(listing).to_the_end().record());
}

/// Runs with keys that the operator presses when the program requests them.
#[track_caller]
fn check_typed(keys: &[u16], listing: &str, expected: Expect) {
    let mut running = Running::start(listing);
    running.controller.devices.state.pendant.type_on_request(keys.iter().copied());
    expected.assert_eq(&running.to_the_end().printed());
}

#[test]
fn put_continues_after_its_last_text() {
    check_page(
        r#"
          put("parts: ")
          put(12)
          putln("")
          putln(-1.23456)
          gotoxy(43,17)
          put("x")
        "#,
        expect![[r#"
            parts: 12
            -1.235

               x"#]],
    );
}

#[test]
fn a_full_page_moves_up() {
    check_page(
        r#"
        num n
          for n=1 to 15
            putln(n)
          endFor
          put("1234567890123456789012345678901234567890a")
        "#,
        expect![[r#"
            4
            5
            6
            7
            8
            9
            10
            11
            12
            13
            14
            15
            1234567890123456789012345678901234567890
            a"#]],
    );
}

#[test]
fn cls_empties_the_page_and_titles_stay() {
    check_record(
        r#"
          title("Palletiser")
          put("x")
          cls()
          put("y")
        "#,
        expect![[r#"
            {"t":2e-6,"task":"main~","kind":"title","screen":"","text":"Palletiser"}
            {"t":4e-6,"task":"main~","kind":"put","screen":"","x":0,"y":0,"text":"x"}
            {"t":6e-6,"task":"main~","kind":"cls","screen":""}
            {"t":8e-6,"task":"main~","kind":"put","screen":"","x":0,"y":0,"text":"y"}
        "#]],
    );
}

#[test]
fn screens_are_written_apart_and_shown_one_at_a_time() {
    let listing = r#"
        screen scMain
        screen scPages[2]
        screen scBy["maintenance"]
        program show(screen& x_page)
        begin
          put(x_page,"by reference")
        end
        program start()
          screen l_local
        begin
          put("default")
          putln(scMain,"main")
          put(scMain,1.5)
          title(scPages[1],"second")
          gotoxy(scPages[1],3,4)
          call show(scPages[1])
          put(scBy["maintenance"],"oil")
          put(l_local,"local")
          cls(scPages[0])
          userPage(scMain)
        end
        "#;
    check_record(
        listing,
        expect![[r#"
        {"t":2e-6,"task":"main~","kind":"put","screen":"","x":0,"y":0,"text":"default"}
        {"t":4e-6,"task":"main~","kind":"put","screen":"scMain","x":0,"y":0,"text":"main"}
        {"t":6e-6,"task":"main~","kind":"put","screen":"scMain","x":0,"y":1,"text":"1.5"}
        {"t":8e-6,"task":"main~","kind":"title","screen":"scPages[1]","text":"second"}
        {"t":0.000014,"task":"main~","kind":"put","screen":"scPages[1]","x":3,"y":4,"text":"by reference"}
        {"t":0.000016,"task":"main~","kind":"put","screen":"scBy[\"maintenance\"]","x":0,"y":0,"text":"oil"}
        {"t":0.000018,"task":"main~","kind":"put","screen":"screen4","x":0,"y":0,"text":"local"}
        {"t":0.00002,"task":"main~","kind":"cls","screen":"scPages[0]"}
    "#]],
    );
    check_page(
        listing,
        expect![[r#"
        main
        1.5"#]],
    );
    check_page(
        "screen scMain\n  put(\"default\")\n  put(scMain,\"main\")\n  userPage(scMain)\n  userPage(true)",
        expect!["default"],
    );
}

#[test]
fn text_modes_other_than_the_four_are_an_error() {
    let running = Running::start("  setTextMode(3)\n  setTextMode(0)\n  setTextMode(4)").for_seconds(1);
    assert_eq!(running.printed(), "error 70\n");
}

#[test]
fn wide_characters_take_two_columns() {
    let running = Running::start("  ? getDisplayLen(\"bolt\")\n  ? getDisplayLen(\"中文\")\n  ? getDisplayLen(\"\")")
        .to_the_end();
    assert_eq!(running.printed(), "4\n4\n0\n");
}

#[test]
fn get_gives_the_key_and_the_entered_text() {
    // 1 2 Return, a menu key for a text, any key.
    check_typed(
        &[51, 270, 98, 271, 97],
        r#"
        num nValue = 12
        string sText = "a"
          ? get(nValue)
          ? nValue
          ? get(sText)
          ? sText
          ? get()
        "#,
        expect![[r#"
            270
            123
            271
            ab
            97
        "#]],
    );
}

#[test]
fn esc_leaves_the_variable() {
    check_typed(
        &[51, 255, 98, 255, 255],
        r#"
        num nValue = 12
        string sText = "a"
          ? get(nValue)
          ? nValue
          ? get(sText)
          ? sText
          ? get()
        "#,
        expect![[r#"
            255
            12
            255
            a
            255
        "#]],
    );
}

#[test]
fn the_example_of_get_waits_for_return() {
    check_typed(
        &[53, 271, 54, 270],
        r#"
        num nKey
        num nValue
          do
            nKey=get(nValue)
          until (nKey==270)
          ? nValue
        "#,
        expect![[r#"
            56
        "#]],
    );
}

#[test]
fn get_shows_the_edited_text_and_keeps_the_cursor() {
    let mut running = Running::start("num nSpeed = 50\n  put(\"speed: \")\n  get(nSpeed)\n  put(\"!\")");
    running.controller.devices.state.pendant.type_on_request([263, 263, 55, 270]);
    let running = running.to_the_end();
    expect![[r#"
        {"t":2e-6,"task":"main~","kind":"put","screen":"","x":0,"y":0,"text":"speed: "}
        {"t":4e-6,"task":"main~","kind":"put","screen":"","x":7,"y":0,"text":"50"}
        {"t":0.004,"kind":"put","screen":"","x":7,"y":0,"text":"5 "}
        {"t":0.008,"kind":"put","screen":"","x":7,"y":0,"text":"  "}
        {"t":0.012,"kind":"put","screen":"","x":7,"y":0,"text":"7 "}
        {"t":0.016,"kind":"put","screen":"","x":7,"y":0,"text":"7 "}
        {"t":0.016002,"task":"main~","kind":"put","screen":"","x":7,"y":0,"text":"!"}
    "#]]
    .assert_eq(&running.record());
    expect!["speed: !"].assert_eq(&running.page());
}

#[test]
fn only_the_page_that_is_shown_gets_keys() {
    check_typed(
        &[97, 98],
        r#"
        screen scOther
        program other()
        begin
          ? "other "+chr(get(scOther))
        end
        program start()
        begin
          taskCreate "other",10,other()
          delay(0.1)
          ? "default "+chr(get())
          userPage(scOther)
        end
        "#,
        expect![[r#"
            default a
            other b
        "#]],
    );
}

#[test]
fn a_task_that_is_killed_no_longer_waits_for_a_key() {
    check_typed(
        &[97],
        r#"
        program reads()
        begin
          ? get()
        end
        program start()
        begin
          taskCreate "reads",10,reads()
          delay(0)
          taskKill("reads")
          ? get()
        end
        "#,
        expect![[r#"
            97
        "#]],
    );
}

#[test]
fn get_key_gives_the_last_key_once() {
    let mut running = Running::start("  ? getKey()\n  delay(1)\n  ? getKey()\n  ? getKey()");
    running.controller.devices.state.pendant.tap(97, 0);
    running.controller.devices.state.pendant.tap(271, 0);
    assert_eq!(running.to_the_end().printed(), "271\n-1\n-1\n");
}

#[test]
fn the_example_of_get_key_ends_with_a_key() {
    check_typed(
        &[270],
        r#"
          getKey()
          while (getKey()==-1)
            gotoxy(0,0)
            put(toString("",clock()*10))
            delay(0)
          endWhile
          ? "key"
        "#,
        expect![[r#"
            key
        "#]],
    );
}

#[test]
fn keys_are_pressed_for_a_while_and_some_whatever_is_shown() {
    let mut running = Running::start(
        r#"
        screen scOther
          ? isKeyPressed(97)
          ? isKeyPressed(scOther,97)
          ? isKeyPressed(scOther,281)
          ? isKeyPressed(1e9)
          delay(1)
          ? isKeyPressed(97)
          ? isKeyPressed(281)
        "#,
    );
    running.controller.devices.state.pendant.tap(97, 0);
    running.controller.devices.state.pendant.press(281);
    expect![[r#"
        true
        false
        true
        false
        false
        true
    "#]]
    .assert_eq(&running.to_the_end().printed());
}

#[test]
fn messages_are_shown_and_logged() {
    check_record(
        "  popUpMsg(\"Close the guard\")\n  logMsg(\"gripper lost a part\")",
        expect![[r#"
        {"t":2e-6,"task":"main~","kind":"popup","text":"Close the guard"}
        {"t":4e-6,"task":"main~","kind":"log","level":"info","text":"USR gripper lost a part"}
    "#]],
    );
    check_record(
        "version s8.10\n  popUpMsg(\"Jam\",3)\n  logMsg(\"slow\",2)\n  userPageAlert(\"Tray\")",
        expect![[r#"
        {"t":2e-6,"task":"main~","kind":"popup","text":"Jam"}
        {"t":4e-6,"task":"main~","kind":"log","level":"warning","text":"USR slow"}
        {"t":6e-6,"task":"main~","kind":"popup","text":"Tray"}
    "#]],
    );
}

#[test]
fn too_many_messages_are_lost_until_there_is_time() {
    let running = Running::start(
        r#"
        bool bLogged = true
        num nLogged
        string sLong = "12345678901234567890123456789012345678901234567890123456789012345678901234567890"
          while bLogged
            bLogged=logMsg(sLong)
            nLogged=nLogged+1
          endWhile
          ? nLogged
          while logMsg(sLong)==false
            delay(0)
          endWhile
          ? "logged"
        "#,
    );
    expect![[r#"
        74
        logged
    "#]]
    .assert_eq(&running.to_the_end().printed());
}

#[test]
fn profiles_change_with_every_result() {
    use val3_machine::controller_state::{Profile, Profiles};
    let profile =
        |name: &str, password: &str| Profile { name: name.into(), password: password.into(), controls_speed: false };
    let mut running = Running::start(
        r#"
          ? getProfile()
          ? setProfile("nobody","")
          ? setProfile("setter","4321")
          ? setProfile("staubli","x")
          ? setProfile("setter","1234")
          ? getProfile()
        "#,
    );
    let known = vec![profile("default", ""), profile("setter", "1234")];
    running.controller.devices.state.profiles = Profiles::new(known, profile("default", ""));
    expect![[r#"
        default
        1
        2
        3
        0
        setter
    "#]]
    .assert_eq(&running.to_the_end().printed());
    let mut running = Running::start("  ? setProfile(\"default\",\"\")\n  ? getProfile()");
    running.controller.devices.state.profiles = Profiles::new(vec![profile("default", "")], profile("staubli", "x"));
    assert_eq!(running.to_the_end().printed(), "4\nstaubli\n");
}

#[test]
fn languages_are_those_that_are_installed() {
    let running = Running::start(
        r#"
          ? getLanguage()
          ? setLanguage("chinese")
          ? getLanguage()
          ? setLanguage("klingon")
          ? getLanguage()
        "#,
    );
    assert_eq!(running.to_the_end().printed(), "english\ntrue\nchinese\nfalse\nchinese\n");
}

#[test]
fn the_date_is_that_of_the_clock() {
    use val3_lang::values::date::DateTime;
    use val3_machine::controller_state::Calendar;
    let listing = r#"
        string sMonth
          switch (getDate("%m"))
            case "01"
              sMonth="January"
            break
            default
              sMonth="???"
            break
          endSwitch
          ? getDate(sMonth+" %d, %Y %H:%M:%S")
          delay(60)
          ? getDate("%y-%m-%d %I:%M:%S %p")
        "#;
    let mut running = Running::start(listing);
    let new_year = DateTime { year: 2007, month: 1, day: 1, hour: 13, minute: 45, second: 23 };
    running.controller.devices.state.calendar = Calendar::starting_at(new_year).unwrap();
    assert_eq!(running.to_the_end().printed(), "January 01, 2007 13:45:23\n07-01-01 01:46:23 PM\n");
    let fixed = Running::start("  ? getDate(\"%Y-%m-%d %H:%M:%S\")").to_the_end().printed();
    assert_eq!(fixed, "2024-01-01 00:00:00\n");
}

#[test]
fn questions_are_answered_by_the_operator() {
    check_typed(
        &[270, 255, 98, 270, 99, 255],
        r#"
        version s8.10
        string sOrder = "a"
          ? userPageConfirm("Empty the gripper?")
          ? userPageConfirm("Empty the tray?")
          ? userPagePrompt("Order",sOrder)
          ? sOrder
          ? userPagePrompt("Order",sOrder)
          ? sOrder
        "#,
        expect![[r#"
            true
            false
            true
            ab
            false
            ab
        "#]],
    );
}

#[test]
fn pages_of_html_are_set_and_shown() {
    let mut running = Running::start(
        r#"
        version s8.10
        num nDone = 3
          ? userPage("main")
          ? userPage("missing")
          userPageSet("main","lblDone","innerHTML",nDone)
          userPageSet("main","lblDone","style.color","red")
          userPageSet("main","lblDone","hidden",nDone>2)
        "#,
    );
    let page = HtmlPage { name: "main".to_owned(), ..HtmlPage::default() };
    running.controller.devices.state.pendant.set_html_pages(vec![page]);
    let running = running.to_the_end();
    assert_eq!(running.printed(), "0\n-1\n");
    expect![[r#"
        {"t":6e-6,"task":"main~","kind":"html","page":"main","id":"lblDone","attribute":"innerHTML","value":"3"}
        {"t":8e-6,"task":"main~","kind":"html","page":"main","id":"lblDone","attribute":"style.color","value":"red"}
        {"t":0.00001,"task":"main~","kind":"html","page":"main","id":"lblDone","attribute":"hidden","value":"true"}
    "#]]
    .assert_eq(&running.record());
}

#[test]
fn a_condition_may_wait_for_keys_again_and_again() {
    check_typed(
        &[97, 98, 270],
        "num nKeys\n  wait(get()==270)\n  ? \"Return\"\n  ? watch(getKey()==97,2)\n  ? clock()>2",
        expect![[r#"
            Return
            false
            true
        "#]],
    );
}
