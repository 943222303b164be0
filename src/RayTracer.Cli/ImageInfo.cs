using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>What <c>info</c> tells about a picture.</summary>
internal static class ImageInfo
{
    /// <summary>Tells it.</summary>
    /// <param name="path">The picture's file.</param>
    /// <param name="withHash">Whether the film that it carries is read, for its hash.</param>
    /// <param name="json">As one JSON object.</param>
    /// <param name="streams">Where to write.</param>
    public static void Show(string path, bool withHash, bool json, Streams streams)
    {
        ImageDescription image = ImageFile.Describe(path);
        (FilmHeader Header, string? Hash)? film = FilmExr.Is(path) ? FilmInfo.Read(path, withHash) : null;
        if (json)
        {
            JsonText.Write(streams, writer =>
            {
                WriteJson(writer, image);
                if (film is { } carried)
                {
                    writer.WriteStartObject("film");
                    FilmInfo.WriteJson(writer, carried.Header, carried.Hash);
                    writer.WriteEndObject();
                }
            });
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
            IEnumerable<string> types = layer.GroupBy(c => (c.Type, c.Bits)).Select(g => $"{string.Join(", ", g.Select(c => PlainText.Of(c.ShortName)))} ({g.Key.Bits} bits, {g.Key.Type})");
            output.WriteLine($"{(layer.Key.Length > 0 ? $"layer      {PlainText.Of(layer.Key)}:" : "channels  ")} {string.Join(", ", types)}");
        }

        foreach ((string key, string text) in image.Texts)
        {
            output.WriteLine($"text       {PlainText.Of(key)}: {PlainText.Of(text)}");
        }
    }

    private static void WriteJson(Utf8JsonWriter json, ImageDescription image)
    {
        json.WriteString("kind", "image");
        json.WriteString("format", image.Format);
        json.WriteNumber("width", image.Width);
        json.WriteNumber("height", image.Height);
        json.WriteNumber("frames", image.Frames);
        json.WriteNumber("fileBytes", image.FileBytes);
        json.WriteString("compression", image.Compression);
        json.WriteStartArray("channels");
        foreach (ImageChannel channel in image.Channels)
        {
            json.WriteStartObject();
            json.WriteString("layer", channel.Layer);
            json.WriteString("name", channel.ShortName);
            json.WriteString("type", channel.Type);
            json.WriteNumber("bits", channel.Bits);
            json.WriteEndObject();
        }

        json.WriteEndArray();

        // Keys may be there more than once.
        json.WriteStartObject("texts");
        foreach (IGrouping<string, string> text in image.Texts.GroupBy(t => t.Key, t => t.Value))
        {
            json.WriteString(text.Key, string.Join('\n', text));
        }

        json.WriteEndObject();
    }
}
