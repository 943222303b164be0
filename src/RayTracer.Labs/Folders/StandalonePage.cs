using System.Net;

namespace RayTracer.Labs;

/// <summary>Pages that need nothing but themselves.</summary>
internal static class StandalonePage
{
    /// <summary>A page.</summary>
    /// <param name="title">Its title.</param>
    /// <param name="body">Its body, as HTML.</param>
    public static string Of(string title, string body) => $$"""
        <!doctype html>
        <html lang="en">
        <head>
        <meta charset="utf-8">
        <meta name="viewport" content="width=device-width">
        <title>{{WebUtility.HtmlEncode(title)}}</title>
        <style>
        body { max-width: 46rem; margin: 2rem auto; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif; color: #222; background: #fff }
        pre, code { font-family: ui-monospace, monospace; background: #f4f4f4 }
        pre { padding: .8rem; overflow-x: auto }
        table { border-collapse: collapse }
        td, th { border: 1px solid #ccc; padding: .3rem .6rem; text-align: left }
        img { max-width: 100%; image-rendering: pixelated }
        .right { color: #17662b } .wrong { color: #a31515 }
        </style>
        </head>
        <body>
        {{body}}
        </body>
        </html>

        """;
}
