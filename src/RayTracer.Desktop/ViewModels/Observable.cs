using System.ComponentModel;
using CommunityToolkit.Mvvm.ComponentModel;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Reports the changes of its properties to the views.</summary>
internal abstract class Observable : ObservableObject
{
    private int _reports;

    /// <summary>
    /// Returns whether a change is being reported: what a view sets meanwhile is its adaptation to the change, and not a wish of the user.
    /// </summary>
    protected bool IsReporting => _reports > 0;

    /// <summary>Reports that several properties have changed.</summary>
    protected void Report(params ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            OnPropertyChanged(name);
        }
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(PropertyChangedEventArgs e)
    {
        _reports++;
        base.OnPropertyChanged(e);
        _reports--;
    }
}
