module BlackHole.Spacetime.Schwarzschild.LensDifferentialSpec (spec) where

import BlackHole.Spacetime.Fate
import BlackHole.Spacetime.LightPath
import BlackHole.Spacetime.Observer
import BlackHole.Spacetime.Photon
import BlackHole.Spacetime.Schwarzschild.ExactPath
import BlackHole.Spacetime.Schwarzschild.LensDifferential
import BlackHole.Spacetime.Schwarzschild.LensTable
import BlackHole.Spacetime.Types
import BlackHole.Vector.XYZ (XYZ (..), (*^), (^+^), (^-^))
import qualified BlackHole.Vector.XYZ as XYZ
import Data.Maybe (fromMaybe)
import Support.Generators
import Test.Hspec
import Test.Hspec.QuickCheck (prop)
import Test.QuickCheck

spec :: Spec
spec =
  sequence_
    [ prop
        ( "is the difference quotient of the closed form, for the " ++ observerName observer
            ++ " observer at "
            ++ show r
        )
        $ \(Direction d) (Direction side) ->
          let step = 1e-6
              at = sightLine Schwarzschild observer place
              place = (r / XYZ.norm axis) *^ axis
           in case (at d, at (unit (d ^+^ step *^ side))) of
                (Just (SightLine photon _), Just (SightLine neighbour _)) ->
                  case (escape photon, escape neighbour) of
                    (Just here, Just there)
                      | abs (fromMaybe 0 (impactParameter photon) - 2.598076211353316) > 0.05 ->
                        let expected = (1 / step) *^ (there ^-^ here)
                         in case lensChanges table photon here neighbour neighbour of
                              Just (LensChanges change _) ->
                                counterexample (show (expected, (1 / step) *^ change)) $
                                  XYZ.distance expected ((1 / step) *^ change)
                                    < 1e-3 * (1 + XYZ.norm expected)
                              Nothing -> property False
                    _ -> discard
                _ -> discard
      | observer <- [Static, Orbiting, Falling],
        r <- [2, 12],
        let table = lensTable r
    ]
  where
    axis = XYZ 0.3 0.8 (-0.5)
    unit v = (1 / XYZ.norm v) *^ v
    escape photon =
      case followedFate (followExact Schwarzschild emptyRegion photon (\() _ -> Continue ()) ()) of
        Escaped direction -> Just direction
        _ -> Nothing
