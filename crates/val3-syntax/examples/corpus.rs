fn main() {
    let mut n = 0; let mut bytes = 0; let mut files = vec![]; let mut all=vec![];
    let mut stack = vec![std::path::PathBuf::from(std::env::args().nth(1).unwrap())];
    while let Some(d) = stack.pop() { for e in std::fs::read_dir(d).unwrap().flatten() { let p = e.path(); if p.is_dir() { stack.push(p) } else if p.extension().is_some_and(|x| { let x = x.to_string_lossy().to_lowercase(); x=="pgx"||x=="dtx"||x=="pjx" }) { files.push(p) } } }
    files.sort();
    for f in &files { let d = val3_syntax::encoding::decode(std::fs::read(f).unwrap()); all.push(d.text); }
    let t = std::time::Instant::now();
    let mut toks=0;
    for (f, text) in files.iter().zip(&all) {
        let p = val3_syntax::parse(text); n += 1; bytes += text.len();
        toks += p.errors().len();
        if std::env::args().nth(2).is_none() {
        assert_eq!(p.root().text().to_string(), *text);
        for e in p.errors() { let line = text[..usize::from(e.range.start())].lines().count(); println!("{}:{} {:?} {:?}", f.display(), line, e.kind, text.lines().nth(line.saturating_sub(1))); } }
    }
    let s = t.elapsed().as_secs_f64();
    if let Some(k) = std::env::args().nth(3) { let k: usize = k.parse().unwrap(); let t = std::time::Instant::now(); let mut b=0; for _ in 0..k { for text in &all { let p = val3_syntax::parse(text); b += text.len(); std::hint::black_box(&p); } } eprintln!("loop {:.1} MB/s", b as f64 / t.elapsed().as_secs_f64() / 1e6); }
    if std::env::args().nth(2).as_deref() == Some("hash") { use std::hash::Hasher; for (f, text) in files.iter().zip(&all) { let mut h = std::hash::DefaultHasher::new(); h.write(format!("{:#?}", val3_syntax::parse(text).root()).as_bytes()); println!("{:x} {}", h.finish(), f.display()); } }
    eprintln!("{n} files {bytes} bytes {toks} errors {:.1} MB/s", bytes as f64 / s / 1e6);
}
