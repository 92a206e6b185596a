// Edits that are checked while they are typed.

import { useEffect, useState } from "preact/hooks";
import { messagesOf } from "./findings";
import type { DataModel } from "./model";
import type { DataEdit } from "./protocol";

/** Milliseconds without a key before the server is asked. */
const PAUSE = 200;

export interface Verdict {
  /** The edit is not possible. */
  isRefused: boolean;
  message: string;
}

const FINE: Verdict = { isRefused: false, message: "" };

/** What is wrong with an edit; a sentence instead of an edit is wrong itself. */
export function useChecked(model: DataModel, edit: DataEdit | string | undefined): Verdict {
  const [verdict, setVerdict] = useState(FINE);
  const asked = JSON.stringify(edit);
  useEffect(() => {
    if (edit === undefined || typeof edit === "string") {
      setVerdict(edit === undefined ? FINE : { isRefused: true, message: edit });
      return undefined;
    }
    let isCurrent = true;
    const timer = setTimeout(() => {
      model.check([edit]).then(({ refused, findings }) => {
        if (isCurrent) {
          setVerdict({ isRefused: refused !== null, message: refused ?? messagesOf(findings) });
        }
      }, (fault: unknown) => model.report(fault));
    }, PAUSE);
    return () => {
      isCurrent = false;
      clearTimeout(timer);
    };
  }, [model, asked]);
  return verdict;
}
