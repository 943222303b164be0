namespace RayTracer.Session;

/// <summary>What tells whether a file is still the one that was read.</summary>
/// <param name="Length">Its length in bytes.</param>
/// <param name="Written">When it was written.</param>
public readonly record struct FileStamp(long Length, DateTime Written)
{
    /// <summary>The stamp of a file; of none where it does not exist.</summary>
    public static FileStamp Of(string path)
    {
        FileInfo file = new(path);
        return file.Exists ? new(file.Length, file.LastWriteTimeUtc) : default;
    }
}
