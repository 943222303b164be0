using System.Text;

namespace RayTracer.Imaging;

/// <summary>
/// Files that are there whole or not at all: written under a temporary name in the same folder, flushed to the disk,
/// then renamed over the old file. After a failure the old file is untouched and nothing is left behind.
/// </summary>
internal static class AtomicFile
{
    private const string Ending = ".tmp";
    private const int GuidLength = 32;
    private const int LongestStart = 50;
    private const int LongestName = 255;

    /// <summary>Writes a file.</summary>
    /// <param name="path">The file; its folder must exist. A symbolic link stays one: the file that it names is replaced.</param>
    /// <param name="write">
    /// Writes the content to a stream that can seek. What it throws, other than input/output errors, passes through unchanged.
    /// </param>
    /// <exception cref="ImageWriteException">
    /// The file cannot be written: the folder is missing or not writable, the disk is full, and so on.
    /// </exception>
    public static void Write(string path, Action<Stream> write)
    {
        string? temporary = null;
        try
        {
            if (IsStandardOutput(path))
            {
                WriteOut(write);
                return;
            }

            string target = Target(path);
            temporary = Temporary(target);
            using (var stream = new FileStream(temporary, FileMode.CreateNew, FileAccess.ReadWrite, FileShare.Delete, 1 << 16))
            {
                KeepMode(target, stream);
                write(stream);
                stream.Flush(flushToDisk: true);

                // While it is open, so that nobody takes it for one that was left behind.
                File.Move(temporary, target, overwrite: true);
                temporary = null;
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ImageWriteException($"Cannot write '{path}': {Reason(e, temporary)}.", e);
        }
        finally
        {
            Delete(temporary);
        }
    }

    /// <summary>
    /// Checks before a long computation that a later <see cref="Write"/> has a chance: the folder exists, and no folder has the
    /// file's name.
    /// </summary>
    /// <param name="path">The path of the file to write.</param>
    /// <exception cref="ImageWriteException">The file cannot be written there.</exception>
    public static void Check(string path)
    {
        try
        {
            _ = IsStandardOutput(path) ? path : Target(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ImageWriteException($"Cannot write '{path}': {Reason(e, null)}.", e);
        }
    }

    /// <summary>
    /// As <see cref="Check"/>; and tries whether the folder takes a file: access rights, read-only file systems and quotas have too many
    /// forms to be looked up.
    /// </summary>
    /// <param name="path">The path of the file to write.</param>
    /// <exception cref="ImageWriteException">The file cannot be written there.</exception>
    public static void Try(string path)
    {
        if (IsStandardOutput(path))
        {
            return;
        }

        string? probe = null;
        try
        {
            probe = Temporary(Target(path));
            using FileStream stream = new(probe, FileMode.CreateNew, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new ImageWriteException($"Cannot write '{path}': {Reason(e, probe)}.", e);
        }
    }

    /// <summary>
    /// Deletes the temporary files that processes which were killed have left beside a file: those of its name that nobody has open or
    /// wrote to lately.
    /// </summary>
    /// <param name="path">The file that they were to become.</param>
    /// <param name="before">Those that were last written to before this time, UTC.</param>
    public static void Sweep(string path, DateTime before)
    {
        try
        {
            string target = Target(path);
            string pattern = $"{Start(target)}.{new string('?', GuidLength)}{Ending}";
            foreach (string left in Directory.EnumerateFiles(Path.GetDirectoryName(target)!, pattern, new EnumerationOptions { AttributesToSkip = FileAttributes.None }))
            {
                if (File.GetLastWriteTimeUtc(left) < before)
                {
                    DeleteUnused(left);
                }
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            // They stay: that harms nobody.
        }
    }

    /// <summary>Returns whether a name stands for standard output, in the format of its extension: <c>-.png</c>.</summary>
    public static bool IsStandardOutput(string path) => path.StartsWith("-.", StringComparison.Ordinal) && Path.GetFileNameWithoutExtension(path) == "-";

    /// <summary>A name for a temporary file in the folder of the file that it becomes: a different one for every writer.</summary>
    public static string Temporary(string target) =>
        Path.Combine(Path.GetDirectoryName(target)!, $"{Start(target)}.{Guid.NewGuid():N}{Ending}");

    // Formats go back to what they wrote, which a pipe cannot.
    private static void WriteOut(Action<Stream> write)
    {
        using MemoryStream whole = new();
        write(whole);
        using Stream output = Console.OpenStandardOutput();
        whole.WriteTo(output);
    }

    // The rights that the owner of the old file gave: what nobody else may read stays so.
    private static void KeepMode(string target, FileStream stream)
    {
        if (OperatingSystem.IsWindows() || !File.Exists(target))
        {
            return;
        }

        try
        {
            File.SetUnixFileMode(stream.SafeFileHandle, File.GetUnixFileMode(target));
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // File systems without rights.
        }
    }

    private static string Start(string target)
    {
        string name = Path.GetFileName(target);
        return $".{(name.Length <= LongestStart ? name : name[..LongestStart])}";
    }

    private static string Target(string path)
    {
        if (string.IsNullOrWhiteSpace(path) || path.Contains('\0'))
        {
            throw new NotSupportedException("that is not a file name");
        }

        string full = Path.GetFullPath(path);
        var file = new FileInfo(full);
        string target = file.LinkTarget is null ? full : file.ResolveLinkTarget(returnFinalTarget: true)?.FullName ?? full;
        if (Directory.Exists(target))
        {
            throw new NotSupportedException("that is a folder");
        }

        if (IsEndless(target))
        {
            throw new NotSupportedException("that is a pipe or a device, which a file would replace");
        }

        if (InputFiles.Contain(target))
        {
            throw new NotSupportedException("this file is read, and would be lost: give another name");
        }

        // Else it would be found out when the file is renamed: the temporary one has a shorter name.
        string name = Path.GetFileName(target);
        int length = OperatingSystem.IsWindows() ? name.Length : Encoding.UTF8.GetByteCount(name);
        if (length > LongestName)
        {
            throw new NotSupportedException($"its name is too long: it has {length} bytes, and file names have at most {LongestName}");
        }

        string folder = Path.GetDirectoryName(target)!;
        if (!Directory.Exists(folder))
        {
            throw new NotSupportedException($"the folder '{folder}' does not exist");
        }

        return target;
    }

    // Pipes and devices have no length, and none can be set, as it can for an empty file.
    private static bool IsEndless(string target)
    {
        if (OperatingSystem.IsWindows() || !File.Exists(target) || new FileInfo(target).Length > 0)
        {
            return false;
        }

        try
        {
            // For reading too: a pipe that nobody reads would be waited for.
            using FileStream stream = new(target, FileMode.Open, FileAccess.ReadWrite, FileShare.ReadWrite | FileShare.Delete, 1);
            return !stream.CanSeek || !CanSetLength(stream);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            // An empty file that others may not write to.
            return false;
        }
    }

    private static bool CanSetLength(FileStream stream)
    {
        try
        {
            stream.SetLength(0);
            return true;
        }
        catch (Exception e) when (e is IOException or ArgumentException or NotSupportedException)
        {
            return false;
        }
    }

    private static string Reason(Exception e, string? temporary)
    {
        if (e is UnauthorizedAccessException)
        {
            return "access to the folder or file is denied";
        }

        string message = e.Message.ReplaceLineEndings(" ").TrimEnd('.');

        // .NET names the file behind most messages.
        return temporary is null ? message : message.Replace($" : '{temporary}'", "", StringComparison.Ordinal).Replace($"'{temporary}'", "a temporary file beside it", StringComparison.Ordinal);
    }

    private static void DeleteUnused(string left)
    {
        try
        {
            // Refused while somebody writes to it.
            using FileStream own = new(left, FileMode.Open, FileAccess.ReadWrite, FileShare.None, 1, FileOptions.DeleteOnClose);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // Its writer lives, or it is another user's.
        }
    }

    private static void Delete(string? temporary)
    {
        if (temporary is null)
        {
            return;
        }

        try
        {
            File.Delete(temporary);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The folder is gone or closed to us; the failure that matters is already on its way up.
        }
    }
}
