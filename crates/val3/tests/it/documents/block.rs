//! Fenced blocks of a document.

/// A fenced block.
#[derive(Debug, PartialEq)]
pub(super) struct Block<'a> {
    /// Text after the opening fence: language and attributes.
    pub(super) info: &'a str,
    /// Number of the first line, from 1.
    pub(super) line: usize,
    /// Lines without the indentation of the fence.
    pub(super) lines: Vec<&'a str>,
}

impl<'a> Block<'a> {
    /// Value of an attribute such as `file=name`.
    pub(super) fn attribute(&self, name: &str) -> Option<&'a str> {
        self.info.split_whitespace().find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
    }

    pub(super) fn text(&self) -> String {
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// A shell command with the expectations in its comment.
#[derive(Debug, PartialEq)]
pub(super) struct Command {
    /// Line number, from 1.
    pub(super) line: usize,
    pub(super) text: String,
    /// Expected exit code.
    pub(super) code: i32,
}

/// Fenced blocks of a document.
pub(super) fn blocks(document: &str) -> Vec<Block<'_>> {
    let mut blocks: Vec<Block<'_>> = Vec::new();
    let mut open: Option<(usize, Block<'_>)> = None;
    for (line, number) in document.lines().zip(1..) {
        let indentation = line.len() - line.trim_start().len();
        match (open.take(), line.trim_start().strip_prefix("```")) {
            (None, Some(info)) => open = Some((indentation, Block { info, line: number + 1, lines: Vec::new() })),
            (Some((_, block)), Some(_)) => blocks.push(block),
            (Some((fence, mut block)), None) => {
                block.lines.push(line.get(fence.min(indentation)..).unwrap_or_default());
                open = Some((fence, block));
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block has no end");
    blocks
}

/// Commands of a block, without commands that are not executed.
pub(super) fn commands(block: &Block<'_>) -> Vec<Command> {
    let mut commands = Vec::new();
    let mut text = String::new();
    for (line, number) in block.lines.iter().zip(block.line..) {
        if let Some(begun) = line.strip_suffix('\\') {
            text.push_str(begun);
            continue;
        }
        text.push_str(line);
        let line = std::mem::take(&mut text);
        let (command, comment) = line.split_once(" # ").unwrap_or((&line, ""));
        let command = command.trim();
        if command.is_empty() || command.starts_with('#') || comment.contains("not executed: ") {
            continue;
        }
        let code = comment.split_once("exits with ").map_or(0, |(_, rest)| {
            rest.split(|character: char| !character.is_ascii_digit()).next().unwrap().parse().unwrap()
        });
        commands.push(Command { line: number, text: command.to_owned(), code });
    }
    commands
}

/// `val3` commands in a recipe for a service.
pub(super) fn recipe(block: &Block<'_>) -> Vec<Command> {
    let commands = block.lines.iter().zip(block.line..).filter_map(|(line, number)| {
        let start = line.find("val3 check ").or_else(|| line.find("val3 test "))?;
        let rest = line.get(start..)?;
        let text = rest.split(['\'', '"', '|']).next()?.trim();
        Some(Command { line: number, text: text.to_owned(), code: 0 })
    });
    commands.collect()
}

#[test]
fn commands_have_the_meaning_of_their_comments() {
    let document = "1. a list\n\n   ```sh\n   val3 check .  # exits with 1\n   val3 run a \\\n     --power\n   ssh a # not executed: no robot\n   ```\n";
    let [block] = &blocks(document)[..] else { panic!("{document}") };
    let command = |line, text: &str, code| Command { line, text: text.to_owned(), code };
    assert_eq!(commands(block), [command(4, "val3 check .", 1), command(6, "val3 run a   --power", 0)]);
}
