namespace RayTracer.Import;

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
