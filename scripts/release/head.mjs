// What the page's head says once it is known where the page is published: its one address for
// search engines, and what others show of a link to it.

/** The picture that goes with a link; it is beside the page then, and is not kept for times without a network. */
export const PICTURE = "playground.png";

/** The page's HTML with its address; unchanged where there is none. */
export function withAddress(html, address) {
  if (!address) {
    return html;
  }
  const [, title] = /<title>([^<"]*)<\/title>/.exec(html);
  const [, description] = /<meta name="description" content="([^"]*)">/.exec(html);
  const open = { type: "website", title, description, url: address, image: `${address}${PICTURE}` };
  const lines = [
    `<link rel="canonical" href="${address}">`,
    ...Object.entries(open).map(([key, value]) => `<meta property="og:${key}" content="${value}">`),
    '<meta name="twitter:card" content="summary_large_image">',
  ];
  return html.replace("</title>", () => `</title>\n  ${lines.join("\n  ")}`);
}
