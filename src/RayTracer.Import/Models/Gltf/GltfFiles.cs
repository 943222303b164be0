using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads what a glTF file's URIs name: data within the URI, or a file beside it.</summary>
internal sealed class GltfFiles(GltfDocument document)
{
    // Thousands of buffers may name one file.
    private readonly Dictionary<string, ReadOnlyMemory<byte>> _read = [];

    /// <summary>Returns whether a URI names a file that is not there.</summary>
    public bool IsMissing(string uri) =>
        !DataUri.Is(uri) && !uri.Contains(':', StringComparison.Ordinal) && FileSearch.IsMissing(Path.Combine(document.Folder, Uri.UnescapeDataString(uri)));

    /// <summary>The bytes that a property named "uri" refers to.</summary>
    /// <param name="from">The object that holds the URI.</param>
    /// <param name="uri">The URI.</param>
    /// <exception cref="ModelException">There is no such file, or it cannot be read.</exception>
    public ReadOnlyMemory<byte> Read(GltfObject from, string uri)
    {
        if (DataUri.Is(uri))
        {
            return DataUri.Decode(uri) ?? throw from.Error("uri", "the embedded data is not base64, or is damaged");
        }

        if (_read.TryGetValue(uri, out ReadOnlyMemory<byte> known))
        {
            return known;
        }

        int colon = uri.IndexOf(':', StringComparison.Ordinal);
        if (colon > 1 && uri.AsSpan(0, colon).IndexOfAny("/.%") < 0)
        {
            throw from.Error("uri", $"{Quotation.Of(uri)} is not beside the file: only relative paths and embedded data are read");
        }

        try
        {
            string path = Path.Combine(document.Folder, Uri.UnescapeDataString(uri));
            if (FileSearch.Complaint(path) is { } complaint)
            {
                throw from.Error("uri", $"cannot read {Quotation.Of(uri)}: {complaint}");
            }

            using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
            if (stream.Length > Array.MaxLength)
            {
                throw from.Error("uri", $"{Quotation.Of(uri)} is larger than 2 GiB");
            }

            byte[] bytes = new byte[stream.Length];
            stream.ReadExactly(bytes);
            document.Memory.AddFile(bytes.Length);
            _read.Add(uri, bytes);
            return bytes;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw from.Error("uri", $"cannot read {Quotation.Of(uri)}: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}");
        }
    }
}

/// <summary>Content that stands within a URI (RFC 2397).</summary>
internal static class DataUri
{
    /// <summary>True where the URI is one of these.</summary>
    public static bool Is(string uri) => uri.StartsWith("data:", StringComparison.OrdinalIgnoreCase);

    /// <summary>Decodes the content; null where it is not base64 or damaged.</summary>
    /// <param name="uri">The URI.</param>
    public static ReadOnlyMemory<byte>? Decode(string uri)
    {
        int comma = uri.IndexOf(',', StringComparison.Ordinal);
        if (comma < 0 || !uri.AsSpan(0, comma).EndsWith(";base64", StringComparison.OrdinalIgnoreCase))
        {
            return null;
        }

        ReadOnlySpan<char> text = uri.AsSpan(comma + 1);
        byte[] bytes = new byte[((text.Length / 4) + 1) * 3];
        return Convert.TryFromBase64Chars(text, bytes, out int written) ? bytes.AsMemory(0, written) : (ReadOnlyMemory<byte>?)null;
    }
}
