namespace RayTracer.Imaging;

/// <summary>
/// Letters of five by seven dots, for labels in pictures: digits, capitals and some signs. Small letters are shown as capitals, others as a
/// block.
/// </summary>
internal static class SmallFont
{
    /// <summary>Columns from one letter to the next.</summary>
    public const int Advance = 6;

    /// <summary>Rows of a letter.</summary>
    public const int Height = 7;

    private const string Signs = " 0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ.,:-+/%=_()[]{}#\"'<>*";

    // Seven rows of a letter, each of five bits as two digits of base 16: the leftmost dot is 10.
    private static readonly string[] s_rows =
    [
        "00000000000000", "0E11131519110E", "040C040404040E", "0E11010204081F", "1F02040201110E", "02060A121F0202", "1F101E0101110E", "0608101E11110E", "1F010204080808",
        "0E11110E11110E", "0E11110F01020C", "0E11111F111111", "1E11111E11111E", "0E11101010110E", "1C12111111121C", "1F10101E10101F", "1F10101E101010", "0E11101711110F",
        "1111111F111111", "0E04040404040E", "0702020202120C", "11121418141211", "1010101010101F", "111B1515111111", "11111915131111", "0E11111111110E", "1E11111E101010",
        "0E11111115120D", "1E11111E141211", "0F10100E01011E", "1F040404040404", "1111111111110E", "11111111110A04", "1111111515150A", "11110A040A1111", "1111110A040404",
        "1F01020408101F", "00000000000C0C", "000000000C0408", "000C0C000C0C00", "0000001F000000", "0004041F040400", "00010204081000", "18190204081303", "00001F001F0000",
        "0000000000001F", "02040808080402", "08040202020408", "0E08080808080E", "0E02020202020E", "02040408040402", "08040402040408", "0A0A1F0A1F0A0A",
        "0A0A0000000000", "04040000000000", "02040810080402", "08040201020408", "00150E1F0E1500",
    ];

    /// <summary>Returns whether a letter has a dot.</summary>
    /// <param name="letter">The letter.</param>
    /// <param name="x">Column, 0 to 4.</param>
    /// <param name="y">Row, from the top.</param>
    public static bool Has(char letter, int x, int y)
    {
        int sign = Signs.IndexOf(char.ToUpperInvariant(letter), StringComparison.Ordinal);
        return sign < 0 || (Convert.ToInt32(s_rows[sign].Substring(2 * y, 2), 16) >> (4 - x) & 1) != 0;
    }
}
