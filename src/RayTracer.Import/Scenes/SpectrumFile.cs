using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads files of spectra: a wavelength in nm and a number a line, # before comments.</summary>
internal static class SpectrumFile
{
    private const int LargestBytes = 1 << 24;

    /// <summary>The spectrum of a file; null, after an error, where it cannot be read.</summary>
    /// <param name="path">The path of the file.</param>
    /// <param name="name">Its name in the scene.</param>
    /// <param name="place">The place of its name.</param>
    /// <param name="log">Takes what is wrong.</param>
    public static Spectrum? Read(string path, string name, SourcePlace place, ImportLog log)
    {
        try
        {
            string? complaint = FileSearch.Complaint(path) ?? (new FileInfo(path).Length > LargestBytes ? "it is too large for a spectrum" : null);
            if (complaint is not null)
            {
                return log.Fail<Spectrum>(place, $"cannot read {Quotation.Of(name)}: {complaint}");
            }

            string[][] lines = [.. File.ReadLines(path).Select(l => MitsubaNumbers.Words(l.Split('#')[0])).Where(w => w.Length > 0)];
            if (Array.FindIndex(lines, w => w.Length != 2) is var bad and >= 0)
            {
                return log.Fail<Spectrum>(place, $"{Quotation.Of(name)} is not a spectrum: expected a wavelength and a number per line, but one has {lines[bad].Length} words");
            }

            return MitsubaColors.Sampled([.. lines.Select(w => w[0])], [.. lines.Select(w => w[1])], place, log);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return log.Fail<Spectrum>(place, $"cannot read {Quotation.Of(name)}: {e.Message.TrimEnd('.')}");
        }
    }
}
