//! Controller descriptions for each version.

#![allow(clippy::unwrap_used, reason = "a test may fail loudly")]

use expect_test::{Expect, expect};
use proptest::prelude::*;
use val3_backup::info::{controller_info, controller_roots};
use val3_backup::{BackupFiles as _, DateTime, MemoryFiles};

fn files(listed: &[(&str, &str)]) -> MemoryFiles {
    let date = DateTime::parse("2021-01-05T08:00:00");
    MemoryFiles::new(listed.iter().map(|(path, text)| ((*path).to_owned(), text.as_bytes().to_vec(), date)))
}

fn check(listed: &[(&str, &str)], expected: Expect) {
    let files = files(listed);
    for root in controller_roots(files.files()) {
        expected.assert_debug_eq(&controller_info(&files, &root));
    }
}

const PROFILE: &str = r#"<Profile>
  <Password name="password" value="c0ffee" /><Password name="connectionPassword" value="c0ffee11" />
  <Bool name="writeAccess" value="false" /><Bool name="readAccess" value="true" /></Profile>"#;

#[test]
fn s8_is_described() {
    check(
        &[
            (
                "C1/usr/configs/arm.cfx",
                "\u{feff}<arm><String name=\"orderNumber\" value=\"A_001\"/><String name=\"arm\" value=\"tx2_60-S1\"/><String name=\"mount\" value=\"floor\"/></arm>",
            ),
            (
                "C1/usr/configs/cell.cfx",
                "<cell><String name=\"language\" value=\"english\"/><autoStart name=\"packer\" location=\"Disk://packer\"/><String name=\"defaultUser\" value=\"operator\"/></cell>",
            ),
            (
                "C1/usr/configs/controller.cfx",
                "<controller><String name=\"VAL 3\" value=\"Demo\"/><String name=\"serialNumber\" value=\"C_001\"/><Float name=\"powerHourCount\" value=\"94.138545\"/></controller>",
            ),
            (
                "C1/usr/configs/val3version.xml",
                "<Versions><Version name=\"val3\" compatibility=\"11.0\">s8.10.2</Version></Versions>",
            ),
            ("C1/usr/configs/profiles/operator.cfx", PROFILE),
            ("C1/usr/app/val3.Motion.anthro.cfx", ""),
            ("C1/usr/app/val3.Motion.scara.cfx", ""),
            ("C1/usr/usrapp/packer/packer.pjx", "<Project/>"),
            ("C1/usr/usrapp/packer/start.PGX", "<Programs/>"),
            ("C1/usr/usrapp/packer/comm/read.pgx", "<Programs/>"),
        ],
        expect![[r#"
            ControllerInfo {
                serial: Some(
                    "C_001",
                ),
                version: Some(
                    "s8.10.2",
                ),
                arm: Some(
                    "tx2_60-S1",
                ),
                arm_of_drawing: false,
                arm_serial: Some(
                    "A_001",
                ),
                mount: Some(
                    "floor",
                ),
                length_axis3: None,
                simulation: None,
                power_hours: Some(
                    94.138545,
                ),
                language: Some(
                    "english",
                ),
                auto_start: Some(
                    "packer",
                ),
                options: [
                    ControllerOption {
                        name: "VAL 3",
                        state: Trial,
                    },
                ],
                add_ons: [
                    "Motion",
                ],
                applications: [
                    ApplicationInfo {
                        name: "packer",
                        path: "C1/usr/usrapp/packer/packer.pjx",
                        programs: 2,
                        files: 3,
                        size: 32,
                        modified: Some(
                            DateTime(
                                2021-01-05T08:00:00,
                            ),
                        ),
                    },
                ],
                boards: [],
                users: [
                    User {
                        name: "operator",
                        is_default: true,
                        rights: [
                            "readAccess",
                        ],
                        denied: [
                            "writeAccess",
                        ],
                    },
                ],
                unread: [],
            }
        "#]],
    );
}

#[test]
fn s7_has_boards() {
    check(
        &[
            (
                "usr/configs/controller.cfx",
                "<controller><String name=\"testMode\" value=\"\"/><String name=\"valPlast\" value=\"1234-5678\"/><Bool name=\"buildBio\" value=\"true\"/><Bool name=\"buildCio\" value=\"false\"/></controller>",
            ),
            (
                "C1.controller",
                "<LocalController><Version>s7.7.1</Version><Properties><Property><RobotSkin>TX200-HB-L-WS</RobotSkin></Property></Properties></LocalController>",
            ),
        ],
        expect![[r#"
            ControllerInfo {
                serial: None,
                version: Some(
                    "s7.7.1",
                ),
                arm: Some(
                    "TX200-HB-L-WS",
                ),
                arm_of_drawing: true,
                arm_serial: None,
                mount: None,
                length_axis3: None,
                simulation: None,
                power_hours: None,
                language: None,
                auto_start: None,
                options: [
                    ControllerOption {
                        name: "testMode",
                        state: Missing,
                    },
                    ControllerOption {
                        name: "valPlast",
                        state: Installed,
                    },
                ],
                add_ons: [],
                applications: [],
                boards: [
                    Board {
                        name: "bio",
                        exists: true,
                    },
                    Board {
                        name: "cio",
                        exists: false,
                    },
                ],
                users: [],
                unread: [],
            }
        "#]],
    );
}

#[test]
fn s6_has_options_in_sys() {
    check(
        &[
            (
                "sys/configs/options.cfx",
                "<options><String name=\"testMode\" value=\"Demo\"/><String name=\"arm\" value=\"ts60-S1\"/><String name=\"orderNumber\" value=\"A6\"/><String name=\"serialNumber\" value=\"C6\"/></options>",
            ),
            ("usr/usrapp/io/io.pjx", "<project/>"),
        ],
        expect![[r#"
            ControllerInfo {
                serial: Some(
                    "C6",
                ),
                version: None,
                arm: Some(
                    "ts60-S1",
                ),
                arm_of_drawing: false,
                arm_serial: Some(
                    "A6",
                ),
                mount: None,
                length_axis3: None,
                simulation: None,
                power_hours: None,
                language: None,
                auto_start: None,
                options: [
                    ControllerOption {
                        name: "testMode",
                        state: Trial,
                    },
                ],
                add_ons: [],
                applications: [
                    ApplicationInfo {
                        name: "io",
                        path: "usr/usrapp/io/io.pjx",
                        programs: 0,
                        files: 1,
                        size: 10,
                        modified: Some(
                            DateTime(
                                2021-01-05T08:00:00,
                            ),
                        ),
                    },
                ],
                boards: [],
                users: [],
                unread: [],
            }
        "#]],
    );
}

#[test]
fn damaged_files_are_named() {
    check(
        &[("usr/configs/arm.cfx", "<arm><String"), ("usr/configs/profiles/a.cfx", "")],
        expect![[r#"
            ControllerInfo {
                serial: None,
                version: None,
                arm: None,
                arm_of_drawing: false,
                arm_serial: None,
                mount: None,
                length_axis3: None,
                simulation: None,
                power_hours: None,
                language: None,
                auto_start: None,
                options: [],
                add_ons: [],
                applications: [],
                boards: [],
                users: [],
                unread: [
                    UnreadFile {
                        path: "usr/configs/arm.cfx",
                        reason: "line 1: an element is not closed; the file is cut off or damaged",
                    },
                    UnreadFile {
                        path: "usr/configs/profiles/a.cfx",
                        reason: "it is empty; copy it again",
                    },
                ],
            }
        "#]],
    );
}

#[test]
fn no_password_is_part_of_the_description() {
    let files = files(&[("usr/configs/profiles/operator.cfx", PROFILE)]);
    let root = controller_roots(files.files()).remove(0);
    let described = format!("{:?}", controller_info(&files, &root));
    assert!(described.contains("operator") && !described.contains("c0ffee"), "{described}");
}

proptest! {
    #[test]
    fn any_content_is_described(contents in prop::collection::vec(any::<Vec<u8>>(), 6)) {
        let paths = ["usr/configs/arm.cfx", "usr/configs/cell.cfx", "usr/configs/controller.cfx", "x.controller",
            "usr/configs/val3version.xml", "usr/configs/profiles/a.cfx"];
        let listed = paths.into_iter().zip(contents).map(|(path, content)| (path.to_owned(), content, None));
        let files = MemoryFiles::new(listed);
        for root in controller_roots(files.files()) {
            let _ = controller_info(&files, &root);
        }
    }
}
