using System.Text.Json.Nodes;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The pictures of <c>info</c>.</summary>
internal static class ImageInfo
{
    /// <summary>Prints what there is to say of a picture.</summary>
    /// <param name="path">The picture's file.</param>
    /// <param name="withHash">True if the film that it carries is read, for its hash.</param>
    /// <param name="json">As one JSON object.</param>
    /// <param name="streams">The streams to write to.</param>
    public static void Show(string path, bool withHash, bool json, Streams streams)
    {
        ImageDescription image = ImageFile.Describe(path);
        (FilmHeader Header, string? Hash)? film = FilmExr.Is(path) ? FilmInfo.Read(path, withHash) : null;
        if (json)
        {
            JsonObject members = Json(image);
            if (film is { } carried)
            {
                members["film"] = FilmInfo.Json(carried.Header, carried.Hash);
            }

            JsonText.Write(streams, members);
        }
        else
        {
            Write(path, image, streams.Output);
            if (film is { } carried)
            {
                streams.Output.WriteLine("carries its film:");
                FilmInfo.Write(carried.Header, carried.Hash, streams.Output);
            }
        }
    }

    private static void Write(string path, ImageDescription image, TextWriter output)
    {
        output.WriteLine(path);
        output.WriteLine($"image      {image.Format}, {image.Width}×{image.Height} pixels{(image.Frames > 1 ? $", {image.Frames} frames" : "")}, {FilmMemory.Text(image.FileBytes)}");
        output.WriteLine($"packed     {image.Compression}");
        foreach (IGrouping<string, ImageChannel> layer in image.Channels.GroupBy(c => c.Layer).OrderBy(g => g.Key.Length > 0))
        {
            IEnumerable<string> types = layer.GroupBy(c => (c.Type, c.Bits))
                .Select(g => $"{string.Join(", ", g.Select(c => PlainText.Of(c.ShortName)))} ({g.Key.Bits} bits, {g.Key.Type})");
            output.WriteLine(
                $"{(layer.Key.Length > 0 ? $"layer      {PlainText.Of(layer.Key)}:" : "channels  ")} {string.Join(", ", types)}");
        }

        foreach ((string key, string text) in image.Texts)
        {
            output.WriteLine($"text       {PlainText.Of(key)}: {PlainText.Of(text)}");
        }
    }

    private static JsonObject Json(ImageDescription image) => new()
    {
        ["kind"] = "image",
        ["format"] = image.Format,
        ["width"] = image.Width,
        ["height"] = image.Height,
        ["frames"] = image.Frames,
        ["fileBytes"] = image.FileBytes,
        ["compression"] = image.Compression,
        ["channels"] = JsonText.List(image.Channels.Select(
            c => new JsonObject { ["layer"] = c.Layer, ["name"] = c.ShortName, ["type"] = c.Type, ["bits"] = c.Bits })),

        // Keys may be there more than once.
        ["texts"] = new JsonObject(
            image.Texts.GroupBy(t => t.Key, t => t.Value).Select(t => KeyValuePair.Create(t.Key, (JsonNode?)string.Join('\n', t)))),
    };
}
