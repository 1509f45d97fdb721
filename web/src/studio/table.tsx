/** A table of a result. */

import type { ResultTable } from "./server";

export function TableOf({ table }: { table: ResultTable }) {
  const missing = table.count - table.rows.length;
  return (
    <div class="wide" tabIndex={0} role="group" aria-label={table.title}>
      <table>
        <caption>{table.title}</caption>
        <thead>
          <tr>
            {table.head.map((head) => (
              <th scope="col">{head}</th>
            ))}
          </tr>
        </thead>
        <tbody>
          {table.rows.length === 0 && (
            <tr>
              <td colSpan={table.head.length}>none</td>
            </tr>
          )}
          {table.rows.map((row, number) => (
            <tr class={table.strong.includes(number) ? "strong" : ""}>
              {row.map((cell, column) => (
                <td class={table.numeric[column] ? "number" : ""}>{cell}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      {missing > 0 && <p class="quiet">and {missing} more rows, in the files of the command</p>}
    </div>
  );
}
