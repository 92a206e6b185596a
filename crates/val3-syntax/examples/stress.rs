
use val3_syntax::*;
fn main() {
    let mut seed: u64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let mut rnd = move |n: usize| { seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407); ((seed >> 33) as usize) % n.max(1) };
    let pieces = ["endIf\n", "if a\n", "(", ")", "\"", "\n", " ", "<", "]]>", "&", "break\n", "x=1 ", "//", "", "endWhile\n", "else\n", "end\n", "begin\n", "=", "</Code>", "<a>", "case 1\n", "@", "<!--", "<<<<<<< \n"];
    let mut stack = vec![std::path::PathBuf::from(std::env::args().nth(1).unwrap())];
    let mut files = vec![];
    while let Some(d) = stack.pop() { for e in std::fs::read_dir(d).unwrap().flatten() { let p = e.path(); if p.is_dir() { stack.push(p) } else if p.extension().is_some_and(|x| { let x = x.to_string_lossy().to_lowercase(); x=="pgx"||x=="dtx"||x=="pjx" }) { files.push(p) } } }
    let mut n = 0; let mut errs = std::collections::BTreeMap::<usize, usize>::new();
    for f in files {
        let text = encoding::decode(std::fs::read(&f).unwrap()).text;
        if text.len() > 40000 || text.len() < 10 { continue; }
        let before = parse(&text);
        for _ in 0..30 {
            let start = rnd(text.len());
            let len = [0, 1, 3, 10, 40][rnd(5)];
            let end = (start + len).min(text.len());
            let e = Edit { range: TextRange::new((start as u32).into(), (end as u32).into()), insert: pieces[rnd(pieces.len())].to_string() };
            let new = e.apply(&text);
            let a = before.reparse(&text, &e); let b = parse(&new);
            if a != b { println!("DIFF {} {e:?}\n{:?}\n{:?}", f.display(), a.errors(), b.errors()); return; }
            n += 1; *errs.entry(b.errors().len()).or_default() += 1;
            if b.errors().len() >= 6 && len <= 3 { println!("{} {e:?} {:?} -> {:?}", f.file_name().unwrap().display(), &text[text.floor_char_boundary(start.saturating_sub(60))..text.floor_char_boundary((end+30).min(text.len()))], b.errors()); }
        }
    }
    println!("{n} {errs:?}");
}
