using RayTracer.Materials;
using RayTracer.Spectra;

namespace RayTracer.Tests.Spectra;

/// <summary>Refractive indices against those that tables print.</summary>
public class DispersionTests
{
    // Indices of the line d, and Abbe's numbers (the line d less 1 over the lines F less C), as the makers' and handbooks' tables have them.
    [Theory]
    [InlineData(Glass.FusedQuartz, 1.45846, 67.82)]
    [InlineData(Glass.Bk7, 1.51680, 64.17)]
    [InlineData(Glass.Bak4, 1.56883, 55.97)]
    [InlineData(Glass.F2, 1.62004, 36.37)]
    [InlineData(Glass.Sf10, 1.72825, 28.41)]
    [InlineData(Glass.Sf11, 1.78472, 25.76)]
    [InlineData(Glass.Lasf9, 1.85025, 32.17)]
    [InlineData(Glass.Diamond, 2.4175, 55.3)]
    [InlineData(Glass.Sapphire, 1.76817, 72.3)]
    [InlineData(Glass.Water, 1.33340, 55.8)]
    public void Glasses_have_the_indices_and_the_Abbe_numbers_of_the_tables(Glass glass, double index, double abbe)
    {
        Dispersion dispersion = glass.Dispersion();
        double d = dispersion.Index(0.58756f)[0];
        Assert.Equal(index, d, 2e-5);
        Assert.Equal(abbe, (d - 1) / (dispersion.Index(0.48613f)[0] - dispersion.Index(0.65627f)[0]), abbe * 2e-3);
    }

    [Fact]
    public void Every_glass_is_in_the_tables()
    {
        Dispersion[] all = [.. Enum.GetValues<Glass>().Select(g => g.Dispersion())];
        Assert.Equal(10, all.Distinct().Count());
        Assert.All(all, d => Assert.InRange(d.Range().Lowest, 1.3f, d.Range().Highest));
    }

    [Fact]
    public void Cauchys_formula_falls_with_the_square_of_the_wavelength()
    {
        Dispersion dispersion = Dispersion.Cauchy(1.5f, 0.01f);
        Assert.Equal(1.5 + (0.01 / 0.16), dispersion.Index(0.4f)[0], 1e-6);
        Assert.Equal(1.5 + (0.01 / 0.49), dispersion.Index(0.7f)[0], 1e-6);
        Assert.Equal(1.4f, Dispersion.None(1.4f).Index(0.5f)[0]);
    }
}
