using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>Reads files of spectra: a wavelength in nm and a number a line, # before comments.</summary>
internal static class SpectrumFile
{
    private const int LargestBytes = 1 << 24;

    /// <summary>The spectrum in the file that an element names; null, after an error, where it cannot be read.</summary>
    public static Spectrum? Read(MitsubaElement property, MitsubaObject thing)
    {
        string name = property.Attribute("filename")!;
        string path = thing.PathOf(name);
        SourcePlace place = property.PlaceOf("filename");
        try
        {
            string? complaint = FileSearch.Complaint(path) ?? (new FileInfo(path).Length > LargestBytes ? "it is too large for a spectrum" : null);
            if (complaint is not null)
            {
                thing.Log.Error(place, $"cannot read {Quotation.Of(name)}: {complaint}");
                return null;
            }

            string[][] lines = [.. File.ReadLines(path).Select(l => MitsubaNumbers.Words(l.Split('#')[0])).Where(w => w.Length > 0)];
            if (Array.FindIndex(lines, w => w.Length != 2) is var bad and >= 0)
            {
                thing.Log.Error(place, $"{Quotation.Of(name)} is not a spectrum: expected a wavelength and a number per line, but found {Quotation.Of(string.Join(' ', lines[bad]))}");
                return null;
            }

            return MitsubaColors.Sampled([.. lines.Select(w => w[0])], [.. lines.Select(w => w[1])], place, thing.Log);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            thing.Log.Error(place, $"cannot read {Quotation.Of(name)}: {e.Message.TrimEnd('.')}");
            return null;
        }
    }
}
