using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Reads whole model files.</summary>
internal static class ModelBytes
{
    /// <summary>The content of a file.</summary>
    /// <exception cref="ModelException">It has more than 2 GiB.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static byte[] Read(string path)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
        if (stream.Length > Array.MaxLength)
        {
            throw new ModelException($"it has {stream.Length} bytes, and models can have at most 2 GiB");
        }

        byte[] content = GC.AllocateUninitializedArray<byte>((int)stream.Length);
        stream.ReadExactly(content);
        return content;
    }
}
