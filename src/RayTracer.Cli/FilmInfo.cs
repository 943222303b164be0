using System.Text.Json;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Session;

namespace RayTracer.Cli;

/// <summary>What <c>info</c> tells about a film.</summary>
internal static class FilmInfo
{
    /// <summary>Tells it.</summary>
    /// <param name="path">The film.</param>
    /// <param name="withHash">Whether all of it is read, for its hash; this finds damages, too.</param>
    /// <param name="json">As one JSON object.</param>
    /// <param name="streams">Where to write.</param>
    public static void Show(string path, bool withHash, bool json, Streams streams)
    {
        (FilmHeader header, Film? film) = withHash ? FilmFile.Read(path) : (FilmFile.ReadHeader(path), null);
        string? hash = film?.ComputeHash();
        long bytes = new FileInfo(path).Length;
        if (json)
        {
            JsonText.Write(streams, writer => WriteJson(writer, header, hash, bytes));
        }
        else
        {
            Write(path, header, hash, bytes, streams.Output);
        }
    }

    private static int Held(FilmHeader header) => header.Samples.Sum(r => r.Count);

    private static void Write(string path, FilmHeader header, string? hash, long bytes, TextWriter output)
    {
        output.WriteLine(path);
        output.WriteLine($"film       {header.Width}×{header.Height} pixels, {FilmMemory.Text(bytes)}");
        output.WriteLine($"samples    {header.SamplesText}: {Held(header)} of {header.Wanted.Count} wanted ({FilmHeader.Text(header.Wanted)}), {(header.IsComplete ? "complete" : "not complete")}");
        output.WriteLine($"total      {header.Total} samples a pixel of the whole picture");
        if (header.Crop is { } crop)
        {
            output.WriteLine($"crop       {crop.X},{crop.Y},{crop.Width},{crop.Height}");
        }

        output.WriteLine($"scene      {PlainText.Of(header.Scene)}");
        if (header.Overrides.Count > 0)
        {
            output.WriteLine($"options    {PlainText.Of(Shell.Command(header.Overrides)[(Shell.Command([]).Length + 1)..])}");
        }

        output.WriteLine($"software   {PlainText.Of(header.Software)}");
        output.WriteLine($"content    {PlainText.Of(header.Content)}");
        if (hash is not null)
        {
            output.WriteLine($"film hash  {hash}");
        }
    }

    private static void WriteJson(Utf8JsonWriter json, FilmHeader header, string? hash, long bytes)
    {
        json.WriteString("kind", "film");
        json.WriteNumber("width", header.Width);
        json.WriteNumber("height", header.Height);
        json.WriteNumber("fileBytes", bytes);
        json.WriteString("samples", header.SamplesText);
        json.WriteNumber("heldSamples", Held(header));
        json.WriteString("wanted", FilmHeader.Text(header.Wanted));
        json.WriteNumber("wantedSamples", header.Wanted.Count);
        json.WriteNumber("totalSamples", header.Total);
        json.WriteBoolean("complete", header.IsComplete);
        if (header.Crop is { } crop)
        {
            json.WriteStartArray("crop");
            foreach (int number in new[] { crop.X, crop.Y, crop.Width, crop.Height })
            {
                json.WriteNumberValue(number);
            }

            json.WriteEndArray();
        }
        else
        {
            json.WriteNull("crop");
        }

        json.WriteString("scene", header.Scene);
        JsonText.Strings(json, "overrides", header.Overrides);
        json.WriteString("software", header.Software);
        json.WriteString("contentHash", header.Content);
        if (hash is not null)
        {
            json.WriteString("filmHash", hash);
        }
    }
}
