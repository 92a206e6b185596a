//! JSON format for editors and programs.

use std::io::{self, Write};

use serde_json::{Value, json};

use crate::coverage::Coverage;
use crate::program::{Branch, ProgramCoverage};
use crate::share::Share;

/// Writes one object with all files.
///
/// # Errors
/// If writing to `out` fails.
pub fn write(coverage: &Coverage, out: &mut dyn Write) -> io::Result<()> {
    let object = json!({
        "version": 1,
        "lines": share(coverage.line_share()),
        "branches": share(coverage.branch_share()),
        "files": coverage.programs().map(|(path, program)| file(path, program)).collect::<Vec<_>>(),
    });
    writeln!(out, "{object:#}")
}

fn share(share: Share) -> Value {
    json!({ "hit": share.hit, "total": share.total })
}

fn file(path: &str, program: &ProgramCoverage) -> Value {
    let line = |(line, hits): (&u32, &u64)| json!({ "line": line, "hits": hits });
    json!({
        "file": path,
        "application": program.project,
        "program": program.program,
        "lines": program.lines.iter().map(line).collect::<Vec<_>>(),
        "branches": program.branches.iter().map(branch).collect::<Vec<_>>(),
    })
}

fn branch(branch: &Branch) -> Value {
    let sides = branch.sides.iter().map(|side| json!({ "name": side.name, "hits": side.hits }));
    json!({ "line": branch.line, "sides": sides.collect::<Vec<_>>() })
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use crate::example::{example, text};

    #[test]
    fn a_file_has_lines_and_branches_with_sides() {
        expect![[r#"
            {
              "branches": {
                "hit": 4,
                "total": 8
              },
              "files": [
                {
                  "application": "feeder",
                  "branches": [],
                  "file": "usrapp/feeder/feed.pgx",
                  "lines": [
                    {
                      "hits": 0,
                      "line": 5
                    },
                    {
                      "hits": 0,
                      "line": 6
                    }
                  ],
                  "program": "feed"
                },
                {
                  "application": "pal",
                  "branches": [
                    {
                      "line": 10,
                      "sides": [
                        {
                          "hits": 3,
                          "name": "true"
                        },
                        {
                          "hits": 0,
                          "name": "false"
                        }
                      ]
                    },
                    {
                      "line": 13,
                      "sides": [
                        {
                          "hits": 0,
                          "name": "case \"a\""
                        },
                        {
                          "hits": 7,
                          "name": "no case"
                        }
                      ]
                    },
                    {
                      "line": 15,
                      "sides": [
                        {
                          "hits": 0,
                          "name": "true"
                        },
                        {
                          "hits": 0,
                          "name": "false"
                        }
                      ]
                    },
                    {
                      "line": 19,
                      "sides": [
                        {
                          "hits": 1,
                          "name": "true"
                        },
                        {
                          "hits": 1,
                          "name": "false"
                        }
                      ]
                    }
                  ],
                  "file": "usrapp/pal/start.pgx",
                  "lines": [
                    {
                      "hits": 3,
                      "line": 10
                    },
                    {
                      "hits": 3,
                      "line": 11
                    },
                    {
                      "hits": 7,
                      "line": 13
                    },
                    {
                      "hits": 0,
                      "line": 15
                    },
                    {
                      "hits": 0,
                      "line": 16
                    },
                    {
                      "hits": 1,
                      "line": 19
                    },
                    {
                      "hits": 0,
                      "line": 20
                    }
                  ],
                  "program": "start"
                },
                {
                  "application": "pal",
                  "branches": [],
                  "file": "usrapp/pal/stop.pgx",
                  "lines": [
                    {
                      "hits": 2,
                      "line": 4
                    }
                  ],
                  "program": "stop"
                }
              ],
              "lines": {
                "hit": 5,
                "total": 10
              },
              "version": 1
            }
        "#]]
        .assert_eq(&text(|out| super::write(&example(), out)));
    }
}
