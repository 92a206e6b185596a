//! Untrusted text: names, paths, code, settings, output and arguments with control characters and with commands of
//! continuous integration services.

use std::path::Path;
use std::process::{Command, Stdio};

use val3_test::Fixture;

use crate::support::Folder;
use crate::terminal::output_on_terminal;

/// Sequences that set the title of a terminal and clear its screen, in C0 and C1, right-to-left text, and lines that a
/// service would execute.
const EVIL: &str = "\u{1b}]0;x\u{7}\u{9b}2J\u{202e}\u{7f}\u{8}\r::error::a\n::error::b ##[error]c ##vso[task]d";

/// [`EVIL`] without the characters that XML does not allow.
fn in_xml() -> String {
    EVIL.replace(['\u{1b}', '\u{7}', '\u{8}'], "")
}

/// [`EVIL`] in a TOML string.
fn toml() -> String {
    let mut text = String::new();
    for character in EVIL.chars() {
        match character.is_control() {
            true => text += &format!("\\u{:04X}", u32::from(character)),
            false => text.push(character),
        }
    }
    text
}

/// A VAL 3 expression for this string.
fn val3_string(text: &str) -> String {
    let codes: Vec<String> = text.chars().map(|character| format!("chr({})", u32::from(character))).collect();
    codes.join("+")
}

/// An application that outputs [`EVIL`] in every way, and fails.
fn good() -> String {
    let says = format!(
        "sText={}\n? sText\nlogMsg(sText)\npopUpMsg(sText)\nuserPage()\ncls()\ntitle(sText)\nput(sText)\n\
         taskCreate sText,10,fail()\ndelay(1)\n? 1/nZero\n",
        val3_string(EVIL)
    );
    let program = |name: &str| format!("program {name}()\nbegin\n{says}end\n");
    format!(
        "--- appTest\nstring sText\nnum nZero\n{}{}program fail()\nbegin\nnZero=1/nZero\nend\n",
        program("start"),
        program("testOne")
    )
}

/// A folder name with [`EVIL`], without `/` and `:`, which controller paths do not allow.
fn evil_folder() -> String {
    format!("usr{}", EVIL.replace('/', ""))
}

/// A cell in which every name and every text contains [`EVIL`].
fn cell() -> Folder {
    let folder = Folder::empty();
    let (name, code) = (in_xml(), EVIL.replace(['\n', '\r'], " "));
    let application = format!("{}/usrapp/app", evil_folder());
    let file = |end: &str| format!("{application}/{end}");
    let project = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n\
         <Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n<Parameters version=\"s7.11\" \
         stackSize=\"5000\" millimeterUnit=\"true\" />\n<Programs>\n<Program file=\"start.pgx\" />\n\
         <Program file=\"testOne.pgx\" />\n<Program file=\"{name}.pgx\" />\n</Programs>\n<Database>\n\
         <Data file=\"app.dtx\" />\n</Database>\n<Libraries>\n<Library alias=\"{name}\" path=\"{name}\" />\n\
         </Libraries>\n</Project>\n"
    );
    folder.write(&file("app.pjx"), &project);
    let data = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n\
         <Database xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\" \
         xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n<Datas>\n\
         <Data name=\"{name}\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"1\" />\n\
         <Data name=\"sText\" access=\"private\" xsi:type=\"array\" type=\"string\" size=\"1\">\n\
         <Value key=\"0\" value=\"{name}\" />\n</Data>\n\
         <Data name=\"nA\" access=\"private\" xsi:type=\"array\" type=\"{name}\" size=\"{name}\" />\n\
         </Datas>\n</Database>\n"
    );
    folder.write(&file("app.dtx"), &data);
    let wrong = format!("  IF {code}\n  x{code}=1 //{code}\n  y=\"{code}\"\n::error::e\n##[error]f");
    folder.write(&file("start.pgx"), &program("start", &wrong));
    folder.write(&file("testOne.pgx"), &program(&name, &wrong.replace(['\u{1b}', '\u{7}', '\u{8}'], "")));
    for (name, settings) in [("keys", "[rules]\n\"TEXT\" = \"error\"\n"), ("values", "[run]\narm = \"TEXT\"\n")] {
        folder.write(&format!("{name}/val3.toml"), &settings.replace("TEXT", &toml()));
        folder.write(&format!("{name}/app/app.pjx"), &project);
    }
    for (path, text) in Fixture::parse(&good()).files {
        folder.write(&path.replace("usrapp/", "good/"), &text);
    }
    folder
}

fn program(name: &str, body: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\" ?>\n\
         <Programs xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\">\n<Program name=\"{name}\">\n\
         <Code><![CDATA[begin\n{body}\nend]]></Code>\n</Program>\n</Programs>\n"
    )
}

/// Arguments of every command that outputs names, paths, texts or arguments.
fn commands() -> Vec<Vec<String>> {
    let evil = evil_folder();
    let words = |line: &str| -> Vec<String> { line.split(' ').map(|word| word.replace("EVIL", &evil)).collect() };
    let formats =
        ["human", "concise", "val3check", "junit", "checkstyle", "json", "json-lines", "sarif", "gitlab", "rdjson"];
    let checks = formats.map(|format| words(&format!("check EVIL --format {format}")));
    let tests =
        ["human", "json", "json-lines", "junit", "tap"].map(|format| words(&format!("test good --format {format}")));
    let others = [
        "check .",
        "check EVIL good --diff",
        "check good --explain-config",
        "check EVIL --statistics",
        "check missing-EVIL",
        "check keys",
        "check values",
        "run values",
        "eval --app values nA",
        "check EVIL --arm EVIL",
        "check EVIL --select EVIL",
        "check EVIL --baseline EVIL",
        "fmt EVIL --check",
        "fmt EVIL --diff",
        "fmt missing-EVIL",
        "diff EVIL good",
        "diff good EVIL --format markdown",
        "diff good EVIL --format html",
        "diff good EVIL --format json",
        "diff missing-EVIL good",
        "diff --git EVIL",
        "run EVIL",
        "run EVIL/usrapp/app",
        "run good/appTest --screen",
        "run good/appTest --screen --events -",
        "run good/appTest --scene",
        "run good/appTest --script missing-EVIL",
        "run good/appTest --arm EVIL",
        "run good/appTest --keys EVIL",
        "run good/appTest --line EVIL=server:1",
        "eval --app good/appTest sText",
        "eval EVIL",
        "test good --list",
        "test EVIL",
        "test good --filter missing-EVIL",
        "explain EVIL",
        "arm show EVIL",
        "arm list EVIL",
        "EVIL",
        "--EVIL",
        "check --EVIL",
    ];
    checks.into_iter().chain(tests).chain(others.iter().map(|line| words(line))).collect()
}

/// Whether a terminal would execute the character.
fn is_raw(character: char) -> bool {
    let is_direction = matches!(character, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    is_direction || (character.is_control() && !matches!(character, '\t' | '\n'))
}

/// First line that a service would execute.
fn executed(output: &str) -> Option<&str> {
    output
        .split(['\n', '\r'])
        .find(|line| line.trim_start().starts_with("::") || line.contains("##[") || line.contains("##vso["))
}

#[track_caller]
fn check_output(output: &str, args: &[String], is_raw: impl Fn(char) -> bool) {
    let raw: Vec<&str> = output.lines().filter(|line| line.contains(&is_raw)).collect();
    assert!(raw.is_empty(), "val3 {args:?} writes control characters: {raw:#?}");
    assert_eq!(executed(output), None, "val3 {args:?} writes a command");
}

fn words(args: &[String]) -> Vec<&str> {
    args.iter().map(String::as_str).collect()
}

fn in_a_service(folder: &Folder, args: &[String]) -> Command {
    let mut command = folder.command(&words(args));
    command.env("GITHUB_ACTIONS", "true").env("NO_COLOR", "1");
    command
}

#[test]
fn no_command_shows_control_characters_on_a_terminal() {
    let folder = cell();
    for args in commands() {
        let output = output_on_terminal(in_a_service(&folder, &args)).replace("\r\n", "\n");
        assert!(!output.is_empty(), "{args:?}");
        check_output(&output, &args, is_raw);
    }
}

#[test]
fn no_report_has_control_characters() {
    let folder = cell();
    for args in commands() {
        let output = in_a_service(&folder, &args).stdin(Stdio::null()).output().unwrap();
        let (out, errors) = (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap());
        check_output(&errors, &args, is_raw);
        check_output(&out, &args, |character| is_raw(character) && !is_exact(&args));
    }
}

/// Whether the output contains the texts of a program or a patch, which are exact unless written to a terminal.
fn is_exact(args: &[String]) -> bool {
    args[0] == "run" || args[0] == "eval" || args.iter().any(|arg| arg == "--diff")
}

#[test]
fn a_path_with_a_line_break_begins_no_line() {
    let folder = cell();
    for format in ["human", "concise", "val3check", "junit", "checkstyle", "github", "azure", "json", "sarif"] {
        for args in [&["check", &evil_folder()][..], &["test", "good"][..]] {
            let args = [args, &["--format", format]].concat();
            let output = folder.val3(&args);
            let all = format!("{}{}", output.stdout, output.stderr);
            let forged = all.lines().find(|line| line.trim_start().starts_with("::error::"));
            assert_eq!(forged, None, "{args:?}");
        }
    }
}

#[test]
fn commands_of_github_name_the_file() {
    let folder = cell();
    let output = folder.val3(&["check", &evil_folder(), "--format", "github"]);
    // After the service commands, `val3` writes one line about the limit.
    let mut others = output.stdout.lines().filter(|line| !line.starts_with("::"));
    assert!(others.all(|line| line.starts_with("GitHub shows 10 of ")), "{output:?}");
    let path =
        "file=usr␛]0;x␇<9B>2J<202E>␡␈%0D%3A%3Aerror%3A%3Aa%0A%3A%3Aerror%3A%3Ab ##[error]c ##vso[task]d/usrapp/app";
    assert!(output.stdout.contains(path), "{output:?}");
}

/// A program that prints a text.
fn printing(text: &str) -> Folder {
    Folder::with(&format!("? {}\n", val3_string(text)))
}

fn printed(folder: &Folder, to: impl FnOnce(&mut Command)) -> Vec<u8> {
    let mut command = folder.command(&["run", "usrapp/main"]);
    command.env_remove("GITHUB_ACTIONS").stdin(Stdio::null());
    to(&mut command);
    command.output().unwrap().stdout
}

#[test]
fn the_output_of_a_program_is_exact_in_pipes_and_files() {
    let text = "a\u{1b}[2J\u{9b}\u{202e}b";
    let folder = printing(text);
    assert_eq!(printed(&folder, |_| ()), format!("{text}\n").as_bytes());
    let folder = printing("::error::a");
    assert_eq!(printed(&folder, |_| ()), b"::error::a\n");
    assert_eq!(printed(&folder, |command| _ = command.env("GITHUB_ACTIONS", "true")), b":\\:error::a\n");
    let file = folder.path().join("out.txt");
    let mut command = folder.command(&["run", "usrapp/main"]);
    command.env("GITHUB_ACTIONS", "true").stdout(std::fs::File::create(&file).unwrap());
    command.spawn().unwrap().wait().unwrap();
    assert_eq!(std::fs::read(Path::new(&file)).unwrap(), b"::error::a\n");
}

#[test]
fn a_terminal_shows_the_output_of_a_program_with_visible_control_characters() {
    let folder = printing("a\u{1b}]52;c;x\u{7}\u{9b}2Jb");
    let output = output_on_terminal(folder.command(&["run", "usrapp/main"]));
    assert_eq!(output, "a␛]52;c;x␇<9B>2Jb\r\n");
}
