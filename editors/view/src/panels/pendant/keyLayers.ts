// Character keys of the pendant, in the three layers of its Shift key (manual 4.3).

export interface Layer {
  label: string;
  title: string;
  rows: readonly string[];
}

export const LAYERS: readonly Layer[] = [
  { label: "abc", title: "Small letters", rows: ["qwertyuiop", "asdfghjkl<", "zxcvbnm.,="] },
  { label: "123", title: "Digits and signs", rows: ["789+*;()[]", "456-/?:!{}", "1230\"%_.,>"] },
  { label: "ABC", title: "Capital letters", rows: ["QWERTYUIOP", "ASDFGHJKL}", "ZXCVBNM$\\="] },
];
