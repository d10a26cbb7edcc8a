// "Save view" in the header: what is shown, under a title, with a small picture of it.
import { notify } from "../shared/dash.mjs";
import { closest, find } from "../shared/dom.mjs";
import { PAGE } from "../shared/ids.mjs";
import { ask, person } from "../shared/server.mjs";
import { openForm } from "../shared/dialogs.mjs";
import { SAVE_VIEW } from "./ids.mjs";
import { tagsOf, viewFields } from "./list.mjs";
import { pictureOfPage } from "./picture.mjs";

document.addEventListener("click", async (event) => {
  if (!closest(event, `#${SAVE_VIEW}`)) return;
  const address = location.pathname + location.search;
  const picture = await pictureOfPage().catch(() => "");
  const title = find(PAGE)?.querySelector("h1, h2")?.textContent ?? "";
  const name = { name: "author", label: "Your name", value: person.name, hint: "where the server does not know it" };
  openForm("Save this view", [...viewFields({ title }), name], "Save", async (values) => {
    if (values.author.trim()) person.name = values.author;
    await ask("views", { ...values, address, picture, tags: tagsOf(values.tags) });
    notify("View saved", "It is listed on the Boards page.", "accent");
  });
});
