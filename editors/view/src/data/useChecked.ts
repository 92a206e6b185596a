// Edits that are checked during typing.

import { useEffect, useState } from "preact/hooks";
import { messagesOf } from "./findings";
import type { DataModel } from "./model";
import type { DataEdit } from "./protocol";

/** Milliseconds without a key before the server is queried. */
const PAUSE = 200;

export interface Verdict {
  /** Whether the edit is not possible. */
  isRefused: boolean;
  message: string;
}

const FINE: Verdict = { isRefused: false, message: "" };

/** Returns the problem with an edit. A string in place of the edit is itself the problem. */
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
